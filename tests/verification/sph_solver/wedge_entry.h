#pragma once
// Wedges that enter still water at constant speed V, no gravity: force, pressure and jet root against the similarity
// solution of Dobrovol'skaya's problem (1969, doi:10.1017/S0022112069001996), in which everything grows as V t:
//
//   F = C rho V^3 t,   p = c_p rho V^2 / 2,   both functions of the deadrise alone
//
// (tests/data/wedge_similarity_exact.csv and wedge_similarity_pressure.csv). In these tables y = -1 is the apex, y = 0
// still water and lengths are in V t; the jet root is where the free surface is upright.
//
// The engine's wedge is fixed and the water is thrown up at it, the same flow seen from the wedge: then z = 0 is the
// apex and still water is at z = V t. Half of it is computed, with a symmetry plane at x = 0.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "prism.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/equations/kernel.h"
#include "sph_solver/simulation.h"
#include "table_of.h"

namespace tw {
namespace wedge_entry_test {

constexpr double V = 1;  // [m/s]

struct Exact {
    double force = 0, cp_max = 0, y_cp_max = 0, cp_apex = 0, x_root = 0, y_tip = 0;
    std::vector<std::pair<double, double>> cp{};  ///< (y, c_p) along the flank, upwards
};
inline Exact exact_of(double deadrise_deg) {
    Exact e;
    for (const Row& row : table_of("wedge_similarity_exact.csv"))
        if (number(row, "deadrise_deg") == deadrise_deg)
            e = {number(row, "F_over_rhoV3t"), number(row, "cp_max"),         number(row, "y_cpmax_over_Vt"),
                 number(row, "cp_apex"),       number(row, "x_root_over_Vt"), number(row, "y_tip_over_Vt")};
    for (const Row& row : table_of("wedge_similarity_pressure.csv"))
        if (number(row, "deadrise_deg") == deadrise_deg) e.cp.emplace_back(number(row, "y_over_Vt"), number(row, "cp"));
    if (e.force == 0) throw std::runtime_error("no such wedge in the table");
    return e;
}

/// Share of a kernel's support beside a flat wall, in two dimensions: a half on it, all of it from 2h on.
class OpenSupport {
public:
    explicit OpenSupport(double h) : step_(2 * h / steps) {
        const Kernel kernel(h, 2);
        double sum = 0.5;
        for (int i = 0; i <= steps; ++i) {
            share_[static_cast<std::size_t>(i)] = sum;
            double line = 0;  // of the kernel along the wall, (i + 1/2) steps from it
            for (int j = -steps; j < steps; ++j)
                line += step_ * kernel.W(std::hypot((i + 0.5) * step_, (j + 0.5) * step_));
            sum += step_ * line;
        }
    }
    double at(double distance) const {
        return share_[static_cast<std::size_t>(std::clamp(distance / step_, 0.0, double(steps)))];
    }

private:
    static constexpr int steps = 200;
    double step_;  ///< [m]
    std::array<double, steps + 1> share_{};
};

/// How an entry is computed.
struct Entry {
    double deadrise_deg = 30;
    double fineness = 26;  ///< wetted half width, to the jet root, over dp at the end
    double sound = 15;     ///< c0 over the speed of the jet root
    double h_over_dp = SphOptions{}.h_over_dp;
    /// Width and depth of the water over the wetted half width. It floats freely; until sound has been to its edge and
    /// back the wedge does not know that it ends.
    double width() const { return 0.53 * sound; }
};

struct Found {
    double force = 0, cp_max = 0, y_cp_max = 0, cp_apex = 0, x_root = 0;
    std::int64_t held = 0;  ///< stops of particles at the wall
    double cp_error = 0;    ///< root mean square below the peak, of the exact c_p there
};

inline Found enter(const Entry& entry, const Exact& exact) {
    const double root = 1.0 / 3;  // wetted half width at the end [m]
    const double until = root / (exact.x_root * V), slope = std::tan(entry.deadrise_deg * std::numbers::pi / 180);
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = root / entry.fineness;
    s.h_over_dp = entry.h_over_dp;
    s.state_equation.c0 = entry.sound * exact.x_root * V;  // the root moves at x_root V
    s.gravity = Vec3::Zero();
    const double half = std::round(entry.width() * entry.fineness) * s.dp;
    // the wedge reaches over its jet, and stays clear of the domain's faces
    const double height = std::min(1.3 * (1 + exact.y_tip) * V * until, 1.5 * half * slope);
    s.domain = {Vec3(0, -1, -1.5 * half), Vec3(2 * half, 1, half)};
    s.mirrors.on[0][0] = true;
    s.bodies = {prism_along_y({{0, 0}, {height / slope, height}, {-height / slope, height}}, 3)};
    Fluid water = fill_with_fluid(s, {Box{Vec3(0, 0, -half), Vec3(half, 0, 0)}});
    for (double& depth : water.depth) depth = 0;
    Simulation simulation(s, water);
    for (float& w : simulation.fields_to_set().w) w = static_cast<float>(V);

    // c_p at points along the flank, averaged in boxes of the similarity coordinate y over the second half of the entry
    PointSamples flank;
    for (double z = 0; z < height; z += s.dp / 2 * std::sin(std::atan(slope)))
        flank.places.emplace_back(z / slope, 0, z);
    constexpr int boxes = 60;
    const double box = (1 + exact.y_tip) / boxes;
    std::array<double, boxes> cp{}, samples{};
    double impulse = 0, before = 0, t1 = 0, impulse1 = 0;
    while (simulation.time() < until) {
        simulation.step();
        impulse += simulation.load().force.z() * (simulation.time() - before);
        before = simulation.time();
        if (before <= 0.4 * until) t1 = before, impulse1 = impulse;
        if (before < 0.5 * until || simulation.steps() % 4 != 0) continue;
        simulation.sample(flank);
        for (std::size_t k = 0; k < flank.places.size(); ++k) {
            const auto b = static_cast<std::size_t>(flank.places[k].z() / (V * before) / box);
            if (b >= boxes) break;
            if (flank.support[k] > SurfaceSamples::has_pressure) cp[b] += flank.p[k] / (0.5 * s.rho0 * V * V);
            samples[b] += 1;
        }
    }
    Found f;
    f.held = simulation.ledger().held;
    // F = C rho V^3 t, so the impulse between t1 and t is C rho V^3 (t^2 - t1^2) / 2
    f.force = 2 * (impulse - impulse1) / (s.rho0 * V * V * V / 2 * (before * before - t1 * t1));
    double squares = 0, exact_squares = 0;
    for (std::size_t b = 0; b < boxes; ++b) {
        const double mean = samples[b] > 0 ? cp[b] / samples[b] : 0, y = (double(b) + 0.5) * box - 1;
        if (b == 0) f.cp_apex = mean;
        if (mean > f.cp_max) f.cp_max = mean, f.y_cp_max = y;
        if (y > std::max(exact.y_cp_max, 0.0) - 0.1) continue;
        std::size_t k = 1;
        while (k + 1 < exact.cp.size() && exact.cp[k].first < y) ++k;
        const auto [y0, c0] = exact.cp[k - 1];
        const auto [y1, c1] = exact.cp[k];
        const double there = c0 + (c1 - c0) * (y - y0) / (y1 - y0);
        squares += (mean - there) * (mean - there), exact_squares += there * there;
    }
    f.cp_error = std::sqrt(squares / exact_squares);

    // jet root: the place nearest to the symmetry plane that has no water, outside the wedge. On a free surface the
    // water takes half of the support that the wedge leaves.
    const OpenSupport open(s.h_over_dp * s.dp);
    PointSamples round;
    const double step = s.dp / 4;
    for (double z = 0; z < (1 + exact.y_tip) * V * until; z += step)
        for (double x = z / slope + step; x < 1.5 * root; x += step) round.places.emplace_back(x, 0, z);
    simulation.sample(round);
    f.x_root = 1e9;
    for (std::size_t k = 0; k < round.places.size(); ++k) {
        const double from_flank = (round.places[k].x() * slope - round.places[k].z()) / std::hypot(1, slope);
        if (round.support[k] < 0.5 * open.at(from_flank))
            f.x_root = std::min(f.x_root, round.places[k].x() / (V * before));
    }
    return f;
}

inline void print_head() {
    std::printf("wedges entering water; F over rho V^3 t, places over V t, root in spacings at the end\n");
    std::printf("  deg  root c0/root h/dp | F exact    found         | c_p max exact  found  at y exact  found |");
    std::printf(" apex c_p exact  found | rms c_p | root x exact  found      off | held  s\n");
}
inline Found print(const Entry& e) {
    const Exact x = exact_of(e.deadrise_deg);
    const auto start = std::chrono::steady_clock::now();
    const Found f = enter(e, x);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    std::printf("  %3.0f  %3.0f  %5.4g   %4.3g | %7.3f  %7.3f (%+5.1f %%) |", e.deadrise_deg, e.fineness, e.sound,
                e.h_over_dp, x.force, f.force, 100 * (f.force / x.force - 1));
    std::printf(" %6.2f %6.2f (%+5.1f %%) %6.3f %6.3f |", x.cp_max, f.cp_max, 100 * (f.cp_max / x.cp_max - 1),
                x.y_cp_max, f.y_cp_max);
    std::printf(" %6.2f %6.2f | %5.1f %% | %6.3f %6.3f  %+4.1f dp | %ld  %.1f\n", x.cp_apex, f.cp_apex,
                100 * f.cp_error, x.x_root, f.x_root, (f.x_root / x.x_root - 1) * e.fineness, static_cast<long>(f.held),
                taken.count());
    std::fflush(stdout);
    return f;
}

}  // namespace wedge_entry_test
}  // namespace tw
