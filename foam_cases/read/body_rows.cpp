#include "foam_cases/read/body_rows.h"

#include <fmt/format.h>

#include <cmath>

#include "foam_cases/body_axes.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/step_loads.h"
#include "record/hull_motion.h"
#include "scene/new_record.h"
#include "scene/solids/hull_motion.h"

namespace tw {
namespace {

constexpr std::size_t false_starts = 3;  // rows whose force is that of the impulsive start

/// A prescribed body is where its law has it.
std::vector<BodyPlace> prescribed_places(const CasePlan& plan, const std::vector<double>& times) {
    RigidBody body(plan.moving().motion);
    std::vector<BodyPlace> places;
    for (const double t : times) {
        body.drift(t - body.state().time);
        const RigidBody::State& s = body.state();
        places.push_back({t, s.centre, s.velocity, body.spin(), s.attitude});
    }
    return places;
}

/// One of several bodies, where each step of the log has left it.
std::vector<BodyPlace> places_in_log(const SolverLog& log, const std::string& patch) {
    std::vector<BodyPlace> places;
    for (const SolverLog::Step& step : log.steps())
        for (const SolverLog::Body& b : step.bodies)
            if (b.name == patch)
                places.push_back({step.time, b.centre, b.velocity, b.spin, Eigen::Quaterniond(b.attitude)});
    return places;
}

}  // namespace

// Columns: time, centre of rotation, centre of mass, angles of R = Rx Ry Rz, velocity, angular velocity.
std::vector<BodyPlace> free_places(const CasePlan& plan, const std::filesystem::path& post) {
    const Eigen::Matrix3d at_start = body_axes(plan.moving().motion).axes;
    std::vector<BodyPlace> places;
    for (const auto& r : joined_rows(post / "bodyState", "sixDoFRigidBodyState.dat")) {
        if (r.size() != 16) continue;
        const auto vec = [&](std::size_t k) { return Vec3(r[k], r[k + 1], r[k + 2]); };
        const Vec3 angles = vec(7);
        const Eigen::Matrix3d turned =
            (Eigen::AngleAxisd(angles.x(), Vec3::UnitX()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
             Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()))
                .toRotationMatrix();
        places.push_back({r[0], vec(4), vec(10), vec(13), Eigen::Quaterniond(turned * at_start.transpose())});
    }
    return places;
}

std::vector<BodyPlace> body_places(const CasePlan& plan, const BodyInMesh& which, const std::filesystem::path& post,
                                   const SolverLog& log, const std::vector<double>& times) {
    return plan.several_bodies()   ? places_in_log(log, which.patch)
           : which.body.motion.law ? prescribed_places(plan, times)
                                   : free_places(plan, post);
}

void read_free_hull(const CasePlan& plan, const std::filesystem::path& post, RunRecord& record) {
    Table& t = record.table(hull_motion_table);
    t.time.clear();
    t.columns.clear();
    for (const BodyPlace& p : free_places(plan, post)) {
        RigidBody::State state;
        state.centre = p.centre, state.attitude = p.attitude, state.velocity = p.velocity;
        append_hull_motion(t, p.time, *plan.scene->hull, state, p.spin);
    }
}

Surface free_hull_at(const CasePlan& plan, const std::filesystem::path& post, double time) {
    Surface surface = plan.moving().surface;
    const Vec3& start = plan.moving().motion.mass.centre;
    BodyPlace at;
    at.centre = start;
    for (const BodyPlace& p : free_places(plan, post))
        if (p.time <= time * (1 + 1e-9)) at = p;
    for (Vec3& x : surface.points) x = at.centre + at.attitude * (x - start);
    return surface;
}

void read_body(const CasePlan& plan, const BodyInMesh& which, const std::filesystem::path& post, const SolverLog& log,
               RunRecord& record) {
    const Scene& scene = *plan.scene;
    const MovingBody& body = which.body;
    const StepLoads loads = read_loads(post / which.forces());
    const std::vector<BodyPlace> places = body_places(plan, which, post, log, loads.time);
    const Vec3 reference = moment_reference(scene);
    const double share = 1 / scene.span();

    Table& t = record.table(body_table(body.name));
    t.time.clear();
    t.columns.clear();
    std::size_t row = 0;
    const auto put = [&](const std::string& name, const std::string& unit, double value) {
        t.set(row, name, unit, value + 0.0);
    };
    const auto put_all = [&](const char* name, const std::string& unit, const Vec3& v) {
        for (int a = 0; a < 3; ++a) put(fmt::format(fmt::runtime(name), "xyz"[a]), unit, v[a]);
    };
    const std::string N = scene.spanwise_unit("N"), Nm = scene.spanwise_unit("N m");
    // the log has times as folders are named, function objects with all their digits
    const double same_time = plan.several_bodies() ? std::pow(10, 1 - plan.time_precision) : 1e-9;
    std::size_t at = 0;
    for (const BodyPlace& p : places) {
        while (at < loads.time.size() && loads.time[at] < p.time * (1 - same_time)) ++at;
        if (at == loads.time.size()) break;
        if (loads.time[at] > p.time * (1 + same_time)) continue;
        Vec3 force, moment;
        for (int a = 0; a < 3; ++a) {
            const auto k = static_cast<std::size_t>(a);
            force[a] = share * (loads.pressure[at][k] + loads.viscous[at][k]);
            moment[a] = share * (loads.pressure[at][k + 3] + loads.viscous[at][k + 3]);
        }
        if (at < false_starts) force = moment = Vec3::Constant(std::nan(""));
        moment -= (p.centre - reference).cross(force);
        const Eigen::Quaterniond q = p.attitude.w() < 0 ? Eigen::Quaterniond(-p.attitude.coeffs()) : p.attitude;
        double lowest = HUGE_VAL;
        for (const Vec3& corner : body.surface.points)
            lowest = std::min(lowest, (p.centre + q * (corner - body.motion.mass.centre)).z());
        row = t.append(p.time);
        put_all("{}", "m", p.centre);
        put("lowest", "m", lowest);
        put("q0", "-", q.w());
        put_all("q{}", "-", q.vec());
        put_all("v{}", "m/s", p.velocity);
        put_all("spin_{}", "rad/s", p.spin);
        put_all("f{}", N, force);
        put_all("m{}", Nm, moment);
        put_all("f{}_body", N, q.conjugate() * force);
        put_all("m{}_body", Nm, q.conjugate() * moment);
    }
}

}  // namespace tw
