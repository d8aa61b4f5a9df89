// The right-hand side against another code's: PySPH's rates for a free block of jittered water
// (benchmarks/pysph_rates.py).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "sph_solver/simulation.h"
#include "tests/data_table.h"

namespace tw {
namespace other_code_test {

/// x, y, z, u, v, w, drho, ax, ay, az, diffusion of drho.
using Row = std::vector<double>;
std::vector<Row> rows_of_the_other_code() { return number_rows("pysph_rates.csv"); }

TEST(OtherCode, FindsTheSameAccelerationsAndDensityDiffusion) {
    const std::vector<Row> rows = rows_of_the_other_code();
    ASSERT_EQ(rows.size(), 8u * 7 * 6);
    SimulationSetup s;
    s.dp = 0.01;
    s.h_over_dp = 1.5;  // as the other code was run
    s.state_equation.c0 = 20;
    s.gravity = Vec3::Zero();
    s.alpha = 0.02;
    s.delta = 0.1;
    s.shifting = 0;
    s.surface_support = 0;  // nowhere is pressure cut
    s.scheme = Scheme::symplectic_euler;
    s.cfl = 0.01;
    s.domain = {Vec3::Constant(-1), Vec3::Constant(1)};
    Fluid block;
    for (const Row& row : rows) block.places.emplace_back(row[0], row[1], row[2]), block.depth.push_back(0);
    Simulation simulation(s, block);
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        p.u[i] = static_cast<float>(rows[i][3]), p.v[i] = static_cast<float>(rows[i][4]);
        p.w[i] = static_cast<float>(rows[i][5]), p.drho[i] = static_cast<float>(rows[i][6]);
    }
    simulation.step();  // its first pair loop changes no density yet, and its second makes the velocities
    const double dt = simulation.time();
    const auto near_a_corner = [](const Row& row) {
        const auto off = [&](std::size_t a, double length) { return std::min(row[a], length - row[a]); };
        return Vec3(off(0, 0.08), off(1, 0.07), off(2, 0.06)).norm() < 0.04;
    };
    Row error(11, 0.0), size(11, 0.0);
    int compared = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const Row& row = rows[static_cast<std::size_t>(p.id[k])];
        const Row made{0,
                       0,
                       0,
                       0,
                       0,
                       0,
                       0,
                       (double(p.u[k]) - row[3]) / dt,
                       (double(p.v[k]) - row[4]) / dt,
                       (double(p.w[k]) - row[5]) / dt,
                       (double(p.drho[k]) - row[6]) / dt};
        // at a corner this code takes no density gradient where the matrix is nearly singular, the other one does
        const std::size_t columns = near_a_corner(row) ? 10 : 11;
        compared += columns == 11;
        for (std::size_t c = 7; c < columns; ++c)
            error[c] = std::max(error[c], std::abs(made[c] - row[c])), size[c] = std::max(size[c], std::abs(row[c]));
    }
    // velocities of 1 m/s and deviations of 5 kg/m3 in single precision, over a step of 7e-6 s: 1e-2 m/s2, 4e-2 kg/m3/s
    for (std::size_t c = 7; c < 10; ++c) EXPECT_LT(error[c], 2e-4 * size[c]) << c << " of " << size[c];
    EXPECT_LT(error[10], 2e-4 * size[10]) << "of " << size[10];
    EXPECT_GT(compared, 80);
    std::printf(
        "  largest differences: %.1e %.1e %.1e of the largest acceleration, %.1e of the largest diffusion (%d "
        "places)\n",
        error[7] / size[7], error[8] / size[8], error[9] / size[9], error[10] / size[10], compared);
}

}  // namespace other_code_test
}  // namespace tw
