// Pressures that a record holds, put onto the plate of its scene (foam_cases/one_way.h).
#include "foam_cases/one_way.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"
#include "foam_cases/read/plate_pressures.h"
#include "structure/generate.h"

namespace tw {
namespace one_way_test {

/// A plate of 0.4 x 0.3 m and 2 mm, hinged at all edges or carried by a frame of 20 kg in all that can only sink.
struct Plate {
    static constexpr double a = 0.4, b = 0.3, t = 2e-3, E = 7e10, nu = 0.3, rho = 2700;
    Scene scene;

    explicit Plate(bool carried) {
        ElasticPlate plate;
        plate.length = a, plate.breadth = b, plate.cells = {20, 16};
        plate.plies = {{structure::isotropic(E, nu, rho), 0, t}};
        plate.large_rotations = false;
        (carried ? plate.carried : plate.hinged) = {"x_min", "x_max", "y_min", "y_max"};
        if (carried) {
            plate.total_mass = 20;
            plate.locked = {true, true, false, true, true, true};
            plate.velocity = Vec3(0, 0, -2);
        }
        plate.gauges = {{"strain", Vec3::Zero(), Vec3(1, 0, 0), true}, {"middle", Vec3::Zero(), {}, true}};
        MovingBody body;
        body.name = "plate";
        body.elastic = plate;
        scene.bodies.push_back(body);
        scene.water.gravity = 0;
    }
    double D() const { return E * t * t * t / (12 * (1 - nu * nu)); }
    double omega(int m, int n) const {
        return pi * pi * (m * m / (a * a) + n * n / (b * b)) * std::sqrt(D() / (rho * t));
    }

    /// A record as the mesh method leaves it, of the net pressure `of_time(t)` [Pa] upward on all elements: the normal
    /// points upward, so on that face it is negative.
    template <class OfTime>
    RunRecord record(double end, double every, OfTime of_time) const {
        RunRecord r;
        Table& p = r.table(plate_pressure_table("plate"));
        for (int k = 0; k * every <= end * (1 + 1e-9); ++k) {
            p.time.push_back(k * every);
            for (int e = 0; e < 20 * 16; ++e)
                p.column("element_" + std::to_string(e), "Pa").values.push_back(-of_time(k * every));
        }
        Table& body = r.table(body_table("plate"));
        for (int k = 0; k <= 200; ++k) body.time.push_back(end * k / 200);
        return r;
    }
};

/// Of a simply supported plate under the pressure q0 sin(W t) from rest: its modes' answer (Timoshenko, Vibration Problems
/// in Engineering, forced vibrations), deflection [m] and strain of the upper face along x [-] at the middle.
struct Answer {
    double deflection = 0, strain = 0;
};
Answer exact(const Plate& p, double q0, double W, double time) {
    Answer sum;
    for (int m = 1; m < 60; m += 2)
        for (int n = 1; n < 60; n += 2) {
            const double w = p.omega(m, n), load = 16 * q0 / (pi * pi * m * n * p.rho * p.t);
            const double q = load * (std::sin(W * time) - W / w * std::sin(w * time)) / (w * w - W * W);
            const double shape = std::sin(m * pi / 2) * std::sin(n * pi / 2);
            sum.deflection += q * shape;
            sum.strain += p.t / 2 * m * m * pi * pi / (p.a * p.a) * q * shape;  // -z w,xx
        }
    return sum;
}

/// From rest under a load that rises from nothing; with small rotations, and with large ones where the plate stays so
/// flat that they say the same.
void expect_answer_of_modes(bool large_rotations) {
    Plate plate(false);
    std::get<ElasticPlate>(*plate.scene.bodies[0].elastic).large_rotations = large_rotations;
    const double T = 2 * pi / plate.omega(1, 1), W = 0.6 * plate.omega(1, 1), q0 = 20;
    RunRecord r = plate.record(2 * T, T / 50, [&](double t) { return q0 * std::sin(W * t); });
    add_one_way_strains(plate.scene, r);
    const Table& body = r.tables.at("body_plate");
    const std::vector<double>&strain = body.find("strain")->values, &w = body.find("middle_z")->values;
    double most_w = 0, most_strain = 0, off_w = 0, off_strain = 0;
    for (std::size_t k = 0; k < body.time.size(); ++k) {
        const Answer a = exact(plate, q0, W, body.time[k]);
        most_w = std::max(most_w, std::abs(a.deflection)), most_strain = std::max(most_strain, std::abs(a.strain));
        off_w = std::max(off_w, std::abs(w[k] - a.deflection));
        off_strain = std::max(off_strain, std::abs(strain[k] - a.strain));
    }
    std::printf("one way, %s rotations: deflection at most %.4g mm, off by %.2g %%; strain %.4g, off by %.2g %%\n",
                large_rotations ? "large" : "small", 1e3 * most_w, 100 * off_w / most_w, most_strain,
                100 * off_strain / most_strain);
    EXPECT_LT(most_w, 0.1 * plate.t) << "or the exact answer, of small deflections, does not hold";
    EXPECT_LT(off_w, 0.015 * most_w);
    EXPECT_LT(off_strain, 0.025 * most_strain);
    EXPECT_EQ(r.attributes.at("structure"), "rigid, strains one way");
    EXPECT_EQ(r.attributes.at("one_way").find("too few"), std::string::npos) << r.attributes.at("one_way");
}

TEST(OneWay, AUniformPressureGivesTheAnswerOfThePlatesModes) { expect_answer_of_modes(false); }
TEST(OneWay, LargeRotationsOfAPlateThatStaysFlatGiveTheSame) { expect_answer_of_modes(true); }

/// What pushes the plate pushes its frame, whatever the plate does between.
TEST(OneWay, TheFrameIsBrakedByTheWholeForce) {
    const Plate plate(true);
    const double force = 2000, end = 0.02, mass = 20;
    RunRecord r = plate.record(end, 2e-4, [&](double) { return force / (plate.a * plate.b); });
    Scene scene = plate.scene;
    std::get<ElasticPlate>(*scene.bodies[0].elastic).gauges = {{"corner", Vec3(-0.2, -0.15, 0), {}, true}};
    add_one_way_strains(scene, r);
    // the frame's own way swings about that of the centre of all mass, by no more than the plate's share of it
    const double share = plate.rho * plate.t * plate.a * plate.b / mass;
    const double expected = -2 * end + force / mass * end * end / 2;
    const double found = r.tables.at("body_plate").find("corner_z")->values.back();
    EXPECT_NEAR(found, expected, 2 * share * 0.02);
    EXPECT_GT(std::abs(found + 2 * end), 0.5 * force / mass * end * end / 2) << "or it is not braked";
}

/// A false start of three rows without a force, in which the rigid plate is stopped by a blow that loads no shell; then
/// the frame goes on from where the plate was and is braked by the pressures that follow.
TEST(OneWay, AFalseStartIsLeftOutAndSaid) {
    const Plate plate(true);
    const double force = 2000, end = 0.02, mass = 20, every = 2e-4, slower = -1.5;
    const auto with_start = [&](double brake) {
        RunRecord r =
            plate.record(end, every, [&](double t) { return (t < 2.5 * every ? 1e6 : force) / (plate.a * plate.b); });
        Table& body = r.table(body_table("plate"));
        body.time.clear();
        for (int k = 0; k <= 100; ++k) {
            const double t = k * every, v = k < 3 ? -2 : slower + brake * (t - 3 * every);
            body.time.push_back(t);
            for (const char* name : {"x", "y", "vx", "vy"}) body.column(name, "").values.push_back(0);
            body.column("z", "m").values.push_back(-0.004);
            body.column("vz", "m/s").values.push_back(v);
            body.column("fz", "N").values.push_back(k < 3 ? std::nan("") : force);
        }
        return r;
    };
    RunRecord r = with_start(force / mass);
    Scene scene = plate.scene;
    std::get<ElasticPlate>(*scene.bodies[0].elastic).gauges = {{"corner", Vec3(-0.2, -0.15, 0), {}, true},
                                                               {"strain", Vec3::Zero(), Vec3(1, 0, 0), true}};
    add_one_way_strains(scene, r);
    const Table& body = r.tables.at("body_plate");
    const std::vector<double>&z = body.find("corner_z")->values, &strain = body.find("strain")->values;
    EXPECT_TRUE(std::isnan(z[2]) && std::isnan(strain[2]));
    EXPECT_NEAR(z[3], -0.004, 1e-12);
    EXPECT_EQ(strain[3], 0);
    const double left = end - 3 * every, share = plate.rho * plate.t * plate.a * plate.b / mass;
    const double expected = -0.004 + slower * left + force / mass * left * left / 2;
    EXPECT_NEAR(z.back(), expected, 2 * share * 0.02);
    double most = 0;
    for (std::size_t k = 3; k < strain.size(); ++k) most = std::max(most, std::abs(strain[k]));
    EXPECT_LT(most, 3e-3) << "the blow of the start has loaded the shell";
    // 0.5 of 0.5 + 1.94 m/s
    EXPECT_NE(r.attributes.at("one_way").find("20 % of the change of velocity that the fluid causes"),
              std::string::npos)
        << r.attributes.at("one_way");
    EXPECT_NE(r.attributes.at("one_way").find("not the response to the impact"), std::string::npos);
    RunRecord braked = with_start(10 * force / mass);
    add_one_way_strains(scene, braked);
    EXPECT_EQ(braked.attributes.at("one_way").find("not the response to the impact"), std::string::npos)
        << braked.attributes.at("one_way");
}

TEST(OneWay, PressuresTooRareForThePlateAreNamed) {
    const Plate plate(false);
    const double T = 2 * pi / plate.omega(1, 1);
    RunRecord rare = plate.record(2 * T, T / 10, [](double) { return 1; });
    add_one_way_strains(plate.scene, rare);
    EXPECT_NE(rare.attributes.at("one_way").find("10 times in the shell's first period"), std::string::npos)
        << rare.attributes.at("one_way");
    EXPECT_NE(rare.attributes.at("one_way").find("too few"), std::string::npos);
    RunRecord none;
    add_one_way_strains(plate.scene, none);
    EXPECT_EQ(none.attributes.count("one_way"), 0u) << "without pressures nothing is claimed";
    RunRecord other = plate.record(T, T / 50, [](double) { return 1; });
    other.table(plate_pressure_table("plate")).columns.pop_back();
    EXPECT_THROW(add_one_way_strains(plate.scene, other), InputError);
}

/// A box of 0.4 x 0.3 x 0.1 m, its faces cut into `nx` by `ny` on both wide sides, with a pressure of each face's place.
HullPatch box_patch(int nx, int ny, const std::function<double(const Vec3&)>& pressure) {
    HullPatch patch;
    const auto face = [&](const Vec3& from, const Vec3& u, const Vec3& v) {  // u x v out of the box
        const int first = static_cast<int>(patch.surface.points.size()), number = static_cast<int>(patch.faces.size());
        for (const Vec3& x : {from, Vec3(from + u), Vec3(from + u + v), Vec3(from + v)})
            patch.surface.points.push_back(x);
        patch.surface.triangles.push_back({first, first + 1, first + 2});
        patch.surface.triangles.push_back({first, first + 2, first + 3});
        patch.face_of_triangle.insert(patch.face_of_triangle.end(), {number, number});
        patch.faces.push_back({.centre = from + (u + v) / 2, .area = -u.cross(v), .pressure = 0});
        patch.faces.back().pressure = pressure(patch.faces.back().centre);
    };
    const double dx = 0.4 / nx, dy = 0.3 / ny;
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j) {
            face(Vec3(-0.2 + dx * i, -0.15 + dy * j, -0.05), Vec3(0, dy, 0), Vec3(dx, 0, 0));
            face(Vec3(-0.2 + dx * i, -0.15 + dy * j, 0.05), Vec3(dx, 0, 0), Vec3(0, dy, 0));
        }
    face(Vec3(-0.2, -0.15, -0.05), Vec3(0, 0, 0.1), Vec3(0, 0.3, 0));
    face(Vec3(0.2, -0.15, -0.05), Vec3(0, 0.3, 0), Vec3(0, 0, 0.1));
    return patch;
}

/// Force and moment pass from the faces of a mesh to the elements of a plate, whatever the sizes of both.
TEST(OneWay, ElementsTakeTheForceAndTheMomentOfTheFaces) {
    structure::ShellMesh mesh = structure::plate_mesh(0.4, 0.3, 20, 16);
    for (Vec3& x : mesh.nodes) x -= Vec3(0.2, 0.15, 0);
    const structure::Shell shell(mesh, structure::Laminate({{structure::isotropic(7e10, 0.3, 2700), 0, 2e-3}}));
    for (const int n : {7, 13, 41}) {
        const HullPatch patch = box_patch(n, n + 2, [](const Vec3& x) {
            return x.z() < 0 ? 3000 + 5000 * x.x() : x.z() > 0 ? 100. : 1e6;
        });
        Eigen::VectorXd p(static_cast<Eigen::Index>(patch.faces.size()));
        for (std::size_t f = 0; f < patch.faces.size(); ++f) p[static_cast<Eigen::Index>(f)] = patch.faces[f].pressure;
        const Eigen::VectorXd load = shell.pressure_load(pressures_from_faces(patch, shell) * p);
        double force = 0, moment = 0, exact_moment = 0;
        for (std::size_t k = 0; k < mesh.nodes.size(); ++k) {
            force += load[static_cast<Eigen::Index>(6 * k + 2)];
            moment += mesh.nodes[k].x() * load[static_cast<Eigen::Index>(6 * k + 2)];
        }
        for (const HullPatch::Face& f : patch.faces) exact_moment += f.centre.x() * f.pressure * f.area.z();
        EXPECT_NEAR(force, 2900 * 0.12, 1e-9 * 2900) << n;
        EXPECT_NEAR(moment / exact_moment, 1, 2e-2) << n;
    }
}

}  // namespace one_way_test
}  // namespace tw
