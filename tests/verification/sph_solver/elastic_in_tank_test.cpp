// Elastic bodies in a tank that moves: they bend under what their own mass feels, and under water, as formulas say.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "column_on_plate.h"
#include "sph_solver/effects/moving_tank.h"

namespace tw {
namespace elastic_in_tank_test {

/// A body whose first point is looked at, stepped as the engine steps it.
class InTank {
public:
    InTank(ElasticSetup setup, const MovingFrame& frame)
        : frame_(frame), body_(Body::of(BodySetup(std::make_shared<const ElasticSetup>(std::move(setup))))) {
        WaterNear water{1000, 0.01, 30};
        water.frame = frame;
        body_->meet(water, {});
    }
    /// Its displacement along z as a multiple of the tank's acceleration, which changes slowly: the mean over the time
    /// from 1 to 2 periods, weighted by that acceleration and a bell [m over m/s2 or rad/s2].
    double answer(double dt) {
        const double period = frame_.law.period;
        double sum = 0, weight = 0;
        while (time_ < 2 * period) {
            body_->look_ahead(dt / 2);
            body_->move({dt, dt / 2, dt / 2});
            time_ += dt;
            if (time_ < period) continue;
            const double a = frame_.law.at(time_).acceleration,
                         bell = std::pow(std::sin(std::numbers::pi * (time_ / period - 1)), 2);
            sum += bell * a * dynamic_cast<const ElasticBody&>(*body_).deflection(0).z(), weight += bell * a * a;
        }
        return sum / weight;
    }

private:
    MovingFrame frame_;
    std::unique_ptr<Body> body_;
    double time_ = 0;
};

MovingFrame slow(bool turns, double amplitude, double period, const Vec3& pivot = Vec3::Zero()) {
    MovingFrame frame;
    frame.law.kind = MotionLaw::Kind::sinusoid;
    frame.law.turns = turns;
    frame.law.axis = turns ? Vec3::UnitY() : Vec3::UnitZ();
    frame.law.amplitude = amplitude, frame.law.period = period, frame.law.ramp = 0.8 * period;
    frame.pivot = pivot;
    return frame;
}

/// A strip that stands out of the tank's wall at x = 0: length, bending and shear stiffness, mass over area.
struct Cantilever {
    static constexpr double L = 0.2, thickness = 0.005, E = 7e8, nu = 0.3, rho = 1000, m = rho * thickness;
    double D = E * std::pow(thickness, 3) / (12 * (1 - nu * nu)), S = 5. / 6 * E / (2 * (1 + nu)) * thickness;
    /// Its lowest mode, w = (1.8751 / L)^2 sqrt(D / m), raises a slow answer by (omega / w)^2.
    double raised(double period) const {
        const double omega = 2 * std::numbers::pi / period, w = std::pow(1.87510 / L, 2) * std::sqrt(D / m);
        return 1 / (1 - std::pow(omega / w, 2));
    }
    ElasticSetup setup(bool large_rotations) const {
        ElasticSetup made =
            strip(0, L, 0, 20, structure::isotropic(E, nu, rho), thickness, [](double x) { return x < 1e-9; });
        std::get<ElasticShell>(made.structure).large_rotations = large_rotations;
        made.points = {{"tip", Vec3(L, 0, 0)}};
        return made;
    }
};

// In a tank that heaves with the acceleration a it feels -m a everywhere: at its tip m a (L^4 / 8 D + L^2 / 2 S).
TEST(ElasticInTank, ACantileverBendsAsTheTankHeaves) {
    const Cantilever c;
    for (const bool large : {false, true}) {
        const double found = InTank(c.setup(large), slow(false, 0.02, 1)).answer(2e-3),
                     exact = -c.m * c.raised(1) * (std::pow(c.L, 4) / (8 * c.D) + c.L * c.L / (2 * c.S));
        std::printf("heave, %s: %.5g m over m/s2, exact %.5g (%+.2f %%)\n", large ? "large rotations" : "linear", found,
                    exact, 100 * (found / exact - 1));
        EXPECT_NEAR(found / exact, 1, 0.005);
    }
}

// In a tank that turns about a pivot the distance r behind its root with the angular acceleration alpha it feels m
// alpha (r + x): at its tip m alpha (r L^4 / 8 + 11 L^5 / 120) / D, and the shear's m alpha (r L^2 / 2 + L^3 / 3) / S.
TEST(ElasticInTank, ACantileverBendsAsTheTankTurns) {
    const Cantilever c;
    const double r = 0.3, L = c.L;
    for (const bool large : {false, true}) {
        const double found = InTank(c.setup(large), slow(true, 0.05, 1, Vec3(-r, 0, 0))).answer(2e-3),
                     exact = c.m * c.raised(1) *
                             ((r * std::pow(L, 4) / 8 + 11 * std::pow(L, 5) / 120) / c.D +
                              (r * L * L / 2 + std::pow(L, 3) / 3) / c.S);
        std::printf("turn, %s: %.5g m over rad/s2, exact %.5g (%+.2f %%)\n", large ? "large rotations" : "linear",
                    found, exact, 100 * (found / exact - 1));
        EXPECT_NEAR(found / exact, 1, 0.005);
    }
}

// A block that stands on the tank's floor between walls, with c^2 = M / rho: its top goes down by a / w^2 (1 / cos(w H
// / c) - 1) in a tank that heaves with a cos(w t).
TEST(ElasticInTank, ABlockIsCompressedAsTheTankHeaves) {
    constexpr double H = 0.04, E = 2e5, nu = 0.3, rho = 1100, period = 0.2, omega = 2 * std::numbers::pi / period;
    structure::SolidMesh mesh = structure::block_mesh(
        {2, 1, 16}, [](const Vec3& p) { return Vec3(0.005 * (p.x() - 0.5), p.y() - 0.5, H * (p.z() - 1)); });
    for (const auto& [name, faces] : std::map(mesh.surfaces))
        mesh.surfaces["wet"].insert(mesh.surfaces["wet"].end(), faces.begin(), faces.end());
    structure::DegreesOfFreedom dofs(mesh.nodes, 3);
    dofs.clamp(mesh.sets.at("z_min"));
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) dofs.hold(std::vector{n}, {0, 1});
    structure::Solid solid(std::move(mesh), {structure::Hyperelastic::saint_venant(E, nu, rho)});
    const Eigen::VectorXd start = Eigen::VectorXd::Zero(solid.dofs());
    ElasticSetup block{.structure = ElasticSolid{.solid = std::move(solid), .wet = "wet", .start = start},
                       .dofs = std::move(dofs),
                       .width = 1};
    block.points = {{"top", Vec3::Zero()}};
    const double found = InTank(std::move(block), slow(false, 1e-3, period)).answer(2e-4),
                 c = std::sqrt(E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / rho),
                 exact = -(1 / std::cos(omega * H / c) - 1) / (omega * omega);
    std::printf("block: %.5g m over m/s2, exact %.5g (%+.2f %%)\n", found, exact, 100 * (found / exact - 1));
    EXPECT_NEAR(found / exact, 1, 0.01);
}

// Water on a plate in a tank that heaves weighs rho (g + a) h, and so does the plate. Both parts of the deflection, of
// g and of a, are fitted to it over the whole run, weighted by a bell that leaves the swing after the release alone.
TEST(ElasticInTank, WaterOnAPlateWeighsMoreAsTheTankRises) {
    const ColumnOnPlate column{0.01};
    SimulationSetup s = column.setup();
    constexpr double T = 0.4;
    s.frame = slow(false, 3 * T * T / (4 * std::numbers::pi * std::numbers::pi), T);  // 3 m/s2
    s.frame->law.ramp = 0, s.frame->law.phase = std::numbers::pi / 2;                 // from rest
    s.effects.emplace_back(MovingTank{});
    Simulation run(s, column.water(s));
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    while (run.time() < T) {
        const double time = run.time();
        run.step();
        const double bell = (run.time() - time) * std::pow(std::sin(std::numbers::pi * time / T), 2);
        const Eigen::Vector2d felt(1, s.frame->law.at(time).acceleration / column.g);
        normal += bell * felt * felt.transpose();
        right -= bell * plate_of(run).deflection(0).z() / column.exact() * felt;
    }
    const Eigen::Vector2d found = normal.inverse() * right;
    std::printf("water on a plate in a tank that heaves: deflection by g %.4f, by a %.4f of the exact one\n", found[0],
                found[1]);
    EXPECT_NEAR(found[0], 1, 0.03);
    EXPECT_NEAR(found[1], 1, 0.05);
}

}  // namespace elastic_in_tank_test
}  // namespace tw
