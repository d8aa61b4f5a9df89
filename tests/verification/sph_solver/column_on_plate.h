#pragma once
#include <algorithm>
#include <cmath>

#include "sph_solver/bodies/elastic/elastic_body.h"
#include "sph_solver/simulation.h"
#include "structure/generate.h"

namespace tw {

/// A strip along x from `from` to `to`, its mid-surface at the height `z`, that bends in the plane y = 0 alone.
/// `supported(x)`: where it is held.
template <class Supported>
inline ElasticSetup strip(double from, double to, double z, int cells, const structure::PlyMaterial& material,
                          double thickness, Supported supported) {
    constexpr double width = 1;
    structure::ShellMesh mesh = structure::plate_mesh(to - from, width, cells, 1);
    for (Vec3& p : mesh.nodes) p += Vec3(from, -width / 2, z);
    structure::Shell shell(mesh, structure::Laminate({{material, 0, thickness}}));
    structure::DegreesOfFreedom dofs(mesh.nodes, 6);
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
        const int node[] = {n};
        dofs.hold(node, {1, 3, 5});
        if (supported(mesh.nodes[static_cast<std::size_t>(n)].x())) dofs.clamp(node);
    }
    return {.structure = ElasticShell{.shell = std::move(shell), .skin = thickness},
            .dofs = std::move(dofs),
            .width = width};
}

/// A tank whose floor is a plate, clamped in its walls.
struct ColumnOnPlate {
    static constexpr double span = 0.2, depth = 0.2, thickness = 0.005, E = 7e8, nu = 0.3, rho = 1000, g = 9.81;
    double dp;

    SimulationSetup setup(int threads = 1, bool large_rotations = false) const {
        SimulationSetup s;
        s.dimensions = 2;
        s.dp = dp;
        s.state_equation.c0 = 20;
        const double skin = 6 * dp, end = span / 2 + 4 * dp;
        s.domain = {Vec3(-span / 2, -dp / 2, -2 * skin), Vec3(span / 2, dp / 2, 1.5 * depth)};
        s.mirrors.on = {{{true, true}, {false, false}, {false, false}}};
        s.threads = threads;
        const int cells = static_cast<int>(std::lround(2 * end / dp));
        ElasticSetup plate = strip(-end, end, -skin / 2, cells, structure::isotropic(E, nu, rho), thickness,
                                   [&](double x) { return std::abs(x) > span / 2 - 1e-9; });
        auto& shell = std::get<ElasticShell>(plate.structure);
        shell.skin = skin;
        shell.large_rotations = large_rotations;
        plate.points = {{"middle", Vec3(0, 0, -skin / 2)}};
        s.bodies.emplace_back(std::make_shared<ElasticSetup>(std::move(plate)));
        return s;
    }
    Fluid water(const SimulationSetup& s) const {
        return fill_with_fluid(s, {Box{Vec3(-span / 2, -dp / 2, 0), Vec3(span / 2, dp / 2, depth)}});
    }
    /// Bending and shear of a span between clamps under the water's and its own weight.
    double exact() const {
        const double D = E * std::pow(thickness, 3) / (12 * (1 - nu * nu)), S = 5. / 6 * E / (2 * (1 + nu)) * thickness;
        const double q = 1000 * g * depth + rho * g * thickness;
        return q * std::pow(span, 4) / (384 * D) + q * span * span / (8 * S);
    }
};

inline const ElasticBody& plate_of(const Simulation& run) { return dynamic_cast<const ElasticBody&>(run.body(0)); }

}  // namespace tw
