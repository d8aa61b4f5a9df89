// What each effect costs: a dam of water over a solid block, every effect alone against none, seconds a step and
// smallest step. Prints a table; the plan's cost column (scene/effects/) is taken from it. Air fills as much
// room as the water, and shortens the step as well.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "meshes/generate.h"
#include "sph_solver/air.h"
#include "sph_solver/effects/acoustic_damping.h"
#include "sph_solver/effects/cavitation.h"
#include "sph_solver/effects/surface_tension.h"
#include "sph_solver/effects/viscosity.h"
#include "sph_solver/simulation.h"

using namespace tw;

namespace {

struct Cost {
    double seconds = 0, dt = 0, bytes = 0;  // per step; of the last step; per particle
};
Cost cost_of(const EffectOptions& effects, bool tension_control, double air_c0, double dp, double seconds) {
    SimulationSetup s;
    s.dp = dp;
    s.state_equation.c0 = 40;
    s.domain = {Vec3(0, 0, 0), Vec3(2, 0.6, 1.2)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    s.bodies = {box_surface({Vec3(1.2, 0.2, -0.1), Vec3(1.5, 0.4, 0.3)})};
    s.threads = 1;
    s.effects = effects;
    s.tension_control = tension_control;
    const std::vector<Box> block{{Vec3(0, 0, 0), Vec3(2, 0.6, 0.6)}};
    Simulation simulation(s, fill_with_fluid(s, block));
    if (air_c0 > 0) {
        AirOptions air;
        air.sound_speed = air_c0;
        add_air(simulation, air, fill_with_air(s, block));
    }
    simulation.step();
    Cost best{1e9, 0, 0};
    using clock = std::chrono::steady_clock;
    const auto begin = clock::now();
    do {  // the quietest of several groups of steps
        const auto start = clock::now();
        for (int k = 0; k < 6; ++k) simulation.step();
        best.seconds = std::min(best.seconds, std::chrono::duration<double>(clock::now() - start).count() / 6);
    } while (std::chrono::duration<double>(clock::now() - begin).count() < seconds);
    best.dt = simulation.dt();
    best.bytes = simulation.bytes() / double(simulation.particles().size());
    return best;
}

}  // namespace

int main(int argc, char** argv) {
    const double seconds = argc > 1 ? std::atof(argv[1]) : 5, dp = argc > 2 ? std::atof(argv[2]) : 0.025;
    struct Row {
        std::string name;
        EffectOptions effects;
        bool tension_control = false;
        double air_c0 = 0;  ///< 0: no air
    };
    std::vector<Row> rows(10);
    rows[0].name = "none";
    rows[1].name = "viscosity, slip", rows[1].effects.push_back(Viscosity{1e-6, false, {}});
    rows[2].name = "viscosity, no slip", rows[2].effects.push_back(Viscosity{1e-6, true, {}});
    rows[3].name = "viscosity, no slip, turbulence", rows[3].effects.push_back(Viscosity{1e-6, true, EddyViscosity{}});
    rows[4].name = "surface tension", rows[4].effects.push_back(SurfaceTension{});
    rows[5].name = "acoustic damping", rows[5].effects.push_back(AcousticDamping{});
    rows[6].name = "cavitation", rows[6].effects.push_back(Cavitation{});
    rows[7].name = "tension control", rows[7].tension_control = true;
    rows[8].name = "air of the water's sound speed", rows[8].air_c0 = 40;
    rows[9].name = "air of 343 m/s", rows[9].air_c0 = 343;
    const Cost none = cost_of(rows[0].effects, false, 0, dp, seconds);
    std::printf("%-32s %12s %10s %12s %10s\n", "effect", "ms a step", "cost", "step", "bytes");
    for (const Row& row : rows) {
        const Cost c = cost_of(row.effects, row.tension_control, row.air_c0, dp, seconds);
        std::printf("%-32s %12.2f %+9.1f%% %12.3g %10.0f\n", row.name.c_str(), 1e3 * c.seconds,
                    100 * (c.seconds / none.seconds - 1), c.dt, c.bytes);
    }
}
