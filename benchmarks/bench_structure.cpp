// What a structure costs beside the water: one step of the laminate study's plate on its drop mass (1600 shells), the
// explicit limit it would have, and one evaluation of the forces of rubber.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "structure/generate.h"
#include "structure/shell/shell.h"
#include "structure/solid/solid.h"
#include "structure/time/generalised_alpha.h"
#include "structure/time/nonlinear_alpha.h"

using namespace tw;
using namespace tw::structure;

namespace {

/// Processor seconds of one call, over `repeats` calls.
template <class Call>
double seconds(int repeats, const Call& call) {
    const std::clock_t from = std::clock();
    for (int k = 0; k < repeats; ++k) call();
    return double(std::clock() - from) / CLOCKS_PER_SEC / repeats;
}
}  // namespace

int main() {
    // Carbon plies of the usual order of magnitude; the study does not print its own.
    const PlyMaterial fabric{60e9, 60e9, 0.05, 4e9, 4e9, 3e9, 1550}, tape{125e9, 8.5e9, 0.3, 4.5e9, 4.5e9, 3e9, 1550};
    const auto layup =
        read_layup("[45 C1/0 C2/45 C2/90 C2]s", {{"C1", {fabric, 0, 0.28e-3}}, {"C2", {tape, 0, 0.16e-3}}});
    const Shell plate(plate_mesh(0.4, 0.4, 40, 40), Laminate(layup));
    DegreesOfFreedom dofs(plate.mesh().nodes, 6);
    dofs.carry({.centre = Vec3(0.2, 0.2, 0.3),
                .mass = 49.6,
                .inertia = Eigen::Matrix3d::Identity(),
                .nodes = plate.mesh().sets.at("edges")});
    const SparseMatrix K = dofs.widened(plate.stiffness()), M = dofs.mass(plate.mass()), T = dofs.basis();
    const double setup = seconds(1, [&] { GeneralisedAlpha time(K, M, T, 1e-5); });
    GeneralisedAlpha time(K, M, T, 1e-5);
    const Eigen::VectorXd pressure = Eigen::VectorXd::Constant(1600, 1e4);
    const double step = seconds(100, [&] { time.step(dofs.widened(plate.pressure_load(pressure))); });
    fmt::print("1600 shells, {} unknowns: factorisation {:.3f} s, step {:.2f} ms; explicit limit {:.2g} s\n", T.cols(),
               setup, 1e3 * step, plate.explicit_step());

    NonlinearAlpha turning(plate, dofs, 2e-5);
    turning.start(Eigen::VectorXd::Zero(dofs.all()), Eigen::VectorXd::Zero(dofs.all()));
    const Eigen::VectorXd load = dofs.widened(plate.pressure_load(Eigen::VectorXd::Constant(1600, 3e3)));
    int iterations = 0;
    const double nonlinear = seconds(50, [&] { iterations += turning.step(load); });
    double deepest = 0;
    for (int n = 0; 6 * n < plate.dofs(); ++n) deepest = std::max(deepest, -turning.displacement()[6 * n + 2]);
    fmt::print(
        "at large rotations, struck by 3 kPa, steps of 2e-5 s: {:.1f} ms, {} iterations each; after 1 ms {:.2f} mm\n",
        1e3 * nonlinear, iterations / 50, 1e3 * deepest);

    const Solid block(block_mesh({20, 20, 20}, [](const Vec3& p) { return p; }),
                      {Hyperelastic::mooney_rivlin(4e5, 1e5, 1e8, 1100)});
    const Eigen::VectorXd u = Eigen::VectorXd::Constant(block.dofs(), 0.01);
    double sum = 0;
    const double force = seconds(5, [&] { sum += block.internal_force(u).norm(); });
    fmt::print("8000 hexahedra: forces {:.2f} us each (sum {:.1g})\n", 1e6 * force / 8000, sum);
}
