#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "meshes/mass_properties.h"
#include "meshes/section.h"
#include "scene/read/read.h"

namespace tw {
namespace {

constexpr const char* dof_names[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

bool is_free(const DegreesOfFreedom& free, std::size_t k) { return k < 3 ? free.along[k] : free.about[k - 3]; }

DegreesOfFreedom read_dofs(SceneSection& s, bool flat) {
    DegreesOfFreedom free;
    const auto lock = [&](std::size_t k) { (k < 3 ? free.along[k] : free.about[k - 3]) = false; };
    for (const std::string& word : s.choices("locked").value_or(std::vector<std::string>{}))
        lock(static_cast<std::size_t>(std::ranges::find(dof_names, word) - std::begin(dof_names)));
    if (flat)
        for (const std::size_t k : {1u, 3u, 5u}) lock(k);
    if (!free.any())
        s.fail("locked",
               "all motions of this free body are locked; leave one free, make the solid an [[obstacle]] "
               "or its motion \"prescribed\"");
    return free;
}

RigidMass read_mass(SceneSection& s, const Surface& surface, const Eigen::Matrix3d& turn, bool free) {
    const auto density = s.number("density"), mass = s.number("mass");
    if (density && mass) s.fail("mass", "given twice: also density; keep one of the two");
    const std::optional<Vec3> centre = s.vector("centre"), inertia = s.vector("inertia");
    RigidMass m = solid_mass(surface, 1);
    const double rounding = 1e-12 * surface.bounds().size().maxCoeff();
    for (double& x : m.centre)
        if (std::abs(x) < rounding) x = 0;
    if (!density && !mass) {
        if (free) s.fail("mass", "missing; a free body needs its mass or its density");
        return {0, centre.value_or(m.centre), Eigen::Matrix3d::Zero()};
    }
    const double factor = mass ? *mass / m.mass : *density;
    m.mass *= factor;
    m.inertia *= factor;
    if (!free) return {m.mass, centre.value_or(m.centre), m.inertia};  // what a law moves needs no inertia
    if (centre) m = with_centre(m, *centre);
    if (inertia) m.inertia = turn * inertia->asDiagonal() * turn.transpose();
    if (const std::string why = impossible(m); !why.empty())
        s.fail(
            inertia  ? "inertia"
            : centre ? "centre"
            : mass   ? "mass"
                     : "density",
            fmt::format(
                "no body has {}{}", why,
                centre && !inertia ? "; the inertia was made from the surface for this centre, so give inertia" : ""));
    return m;
}

}  // namespace

Eigen::Matrix3d turn_of(const Pose& pose) {
    const Surface frame{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {}};
    const Surface turned = posed(frame, pose);
    Eigen::Matrix3d turn;
    for (int a = 0; a < 3; ++a) turn.col(a) = turned.points[static_cast<std::size_t>(a) + 1] - turned.points[0];
    return turn;
}

void read_body(SceneSection& s, MovingBody& b, int dimensions) {
    const bool flat = dimensions == 2;
    Pose pose;
    pose.trim = s.number("trim", 0.0);
    pose.heel = s.number("heel", 0.0);
    for (const auto& [angle_key, angle] : {std::pair{"trim", pose.trim}, {"heel", pose.heel}})
        if (const std::string why = why_angle_is_asked_back(s, angle_key, angle); !why.empty())
            b.findings.push_back({Finding::Level::warning, "plain_angle",
                                  fmt::format("{} of body {}: {}", angle_key, b.name, why), Vec3::Zero()});
    if (const auto position = s.numbers("position")) pose.position = {(*position)[0], (*position)[1], 0};
    std::string key;
    const auto [as_read, note] = read_sound_solid(s, b.source, key);
    if (note) b.findings.push_back(*note);
    pose.draft = s.number("draft").value_or(-as_read.bounds().min.z());
    b.surface = posed(as_read, pose);
    if (flat) try {
            b.surface = section_prism(b.surface);
        } catch (const InputError& e) {
            s.fail(key, fmt::format("two dimensions are the plane y = 0, and {}; move the body with position = [x, y]",
                                    e.what()));
        }

    RigidBodySetup& m = b.motion;
    const bool free = s.choice("motion").value_or("free") == "free";
    const Eigen::Matrix3d turn = turn_of(pose);
    m.mass = read_mass(s, b.surface, turn, free);
    if (free) {
        m.free = read_dofs(s, flat);
        const std::optional<Vec3> velocity = s.vector("velocity");
        const auto speed = s.number("speed");
        if (velocity && speed) s.fail("speed", "given twice: also velocity; keep one of the two");
        m.velocity = velocity.value_or(-speed.value_or(0) * turn.col(0));
        m.spin = s.vector("spin").value_or(Vec3::Zero());
        for (std::size_t k = 0; k < 6; ++k) {
            const auto axis = static_cast<int>(k % 3);
            if (!is_free(m.free, k) && std::abs(k < 3 ? m.velocity[axis] : m.spin[axis]) > 1e-12)
                s.fail(k < 3 ? (speed ? "speed" : "velocity") : "spin",
                       fmt::format("has a part in {}, which is locked{}", dof_names[k],
                                   flat ? " (two dimensions are the plane y = 0)" : ""));
        }
    } else {
        for (const char* of_free : {"locked", "velocity", "speed", "spin", "friction"})
            if (s.has(of_free)) s.fail(of_free, "is for free bodies; the motion of this one is prescribed by law");
        m.law = read_motion_law(s, flat);
    }
    s.finish();
}

double MovingBody::fastest(double g) const {
    const Box box = surface.bounds();
    double reach = 0;
    for (const Vec3& p : surface.points) {
        Vec3 arm = p - motion.mass.centre;
        if (!motion.free.about[0] && !motion.free.about[2]) arm.y() = 0;
        reach = std::max(reach, arm.norm());
    }
    if (motion.law) return motion.law->fastest() * (motion.law->turns ? reach : 1);
    const double falls = motion.free.along[2] ? 2 * g * std::max(0.0, box.min.z()) : 0;
    return std::sqrt(motion.velocity.squaredNorm() + falls) + motion.spin.norm() * reach;
}

}  // namespace tw
