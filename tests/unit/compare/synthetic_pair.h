#pragma once
#include <cmath>
#include <random>

#include "base/numbers.h"
#include "meshes/generate.h"
#include "record/raster.h"
#include "record/run_record.h"

namespace tw {

/// How one synthetic run of a planing prism differs from another.
struct SyntheticRun {
    std::string method = "sph";
    double lift = 2800, drag = 250, moment = 900;  ///< settled means
    double noise = 40;                             ///< standard deviation of the lift [N]
    double duration = 2.0, step = 1e-3;
    double splash = 0.35;  ///< height of the spray sheet [m]
    double wave = 0.08;    ///< wave height in the wake [m]
    unsigned seed = 1;
    bool frames = true;
};

/// Two methods that are 3 % apart in the lift, without frames.
namespace synthetic_pair {
inline const SyntheticRun sph{.frames = false};
inline const SyntheticRun fvm{
    .method = "fvm", .lift = 2722, .drag = 251, .moment = 870, .noise = 15, .seed = 2, .frames = false};
}  // namespace synthetic_pair

/// A record as a solver would leave it: prism of 4 m at 8 m/s, half model, forces with a start-up transient and
/// correlated noise, rasters of a wake with a spray sheet and a drop. Every number in it is invented.
inline RunRecord synthetic_run(const SyntheticRun& o) {
    RunRecord r;
    r.attributes = {{"method", o.method},         {"title", "Planing prism, synthetic"},
                    {"scene_hash", "scene-1"},    {"hull_hash", "hull-1"},
                    {"hull_source", "prismatic"}, {"symmetry_factor", "2"},
                    {"motion", "stream"},         {"code_version", "0.1.0"},
                    {"machine", "test machine"},  {"scene_file", "prism.toml"}};
    r.numbers = {{"speed", 8},
                 {"length", 4},
                 {"beam", 1},
                 {"cut_x_0", 4},
                 {"cut_y_0", 0.75},
                 {"draft", 0.2},
                 {"trim", 5 * pi / 180},
                 {"density", 1000},
                 {"gravity", 9.81},
                 {"kinematic_viscosity", 1e-6},
                 {"duration", o.duration},
                 {"mean_from", 0.5},
                 {"near_hull", 0.04},
                 {"spacing", 0.16}};
    r.scene_text = "title = \"Planing prism, synthetic\"\n";
    const Surface hull = make_hull("prismatic", {{"length", 4.0}, {"beam", 1.0}, {"deadrise", 20 * pi / 180}});
    r.hull = posed(hull, {.trim = 5 * pi / 180, .draft = 0.2});
    for (int t = 0; t < static_cast<int>(r.hull.triangles.size()); ++t) {
        const double z = (r.hull.corner(t, 0).z() + r.hull.corner(t, 1).z() + r.hull.corner(t, 2).z()) / 3;
        const Vec3 n = r.hull.area_vector2(t);
        const bool wet = z < 0.1 && n.z() < 0;
        r.hull_pressure.push_back(static_cast<float>(wet ? 3000 - 8000 * z : 0));
        r.hull_wet.push_back(wet ? 1.0f : 0.0f);
    }

    std::mt19937 random(o.seed);
    std::normal_distribution<double> normal;
    Table& forces = r.table("forces");
    for (const char* c : {"fx", "fz", "fx_pressure", "fz_pressure"}) forces.column(c, "N");
    forces.column("my", "N m");
    if (o.method == "sph")
        forces.column("fz_surface", "N"), forces.column("fz_volume", "N");
    else
        forces.column("fz_air", "N");
    const double memory = std::exp(-o.step / 0.03);  // noise correlated over 30 ms
    double wander = 0;
    for (double t = 0; t <= o.duration + 1e-9; t += o.step) {
        wander = memory * wander + std::sqrt(1 - memory * memory) * normal(random);
        const double start = 1 - std::exp(-t / 0.08), lift = o.lift * start + o.noise * wander + (t < 0.01 ? 5e4 : 0);
        const double drag = o.drag * start + 0.1 * o.noise * wander;
        forces.time.push_back(t);
        forces.column("fx", "N").values.push_back(drag);
        forces.column("fz", "N").values.push_back(lift);
        forces.column("fx_pressure", "N").values.push_back(drag);
        forces.column("fz_pressure", "N").values.push_back(lift);
        forces.column("my", "N m").values.push_back(o.moment * start + 0.3 * o.noise * wander);
        if (o.method == "sph") {
            forces.column("fz_surface", "N").values.push_back(1.02 * lift);
            forces.column("fz_volume", "N").values.push_back(0.99 * lift);
        } else {
            forces.column("fz_air", "N").values.push_back(95 + 0.02 * o.noise * normal(random));
        }
    }
    Table& samples = r.table("samples");
    for (double t = 0; t <= o.duration + 1e-9; t += 0.02) {
        samples.time.push_back(t);
        samples.column("wetted_length", "m").values.push_back(2.35 + 0.01 * normal(random));
        samples.column(o.method == "sph" ? "max_mach" : "max_courant", "-")
            .values.push_back(o.method == "sph" ? 0.11 : 3.9);
        if (o.method == "sph")
            samples.column("particles_lost", "-").values.push_back(0);
        else
            samples.column("ventilation", "-").values.push_back(0.12);
    }
    if (o.frames) {
        r.raster = {{-2.4, 0, -0.6}, 0.08, {88, 38, 20}};
        const double part = r.raster.voxel / 2;
        const auto columns = [&](auto&& pour) {
            for (int i = 0; i < 2 * r.raster.count[0]; ++i)
                for (int j = 0; j < 2 * r.raster.count[1]; ++j)
                    pour(r.raster.origin.x() + (i + 0.5) * part, (j + 0.5) * part);
        };
        Raster wake(r.raster);
        columns([&](double x, double y) {
            const bool hull_here = x > -0.3 && x < 2 && y < 0.5;
            const double behind = x - 2;
            double z = behind > 0 ? o.wave * std::cos(2 * pi * behind / 2.2) * std::exp(-y / 0.9) -
                                        0.16 * std::exp(-behind / 0.8 - y * y / 0.16)
                                  : 0;
            z += o.wave * std::exp(-std::pow((y - 0.55 - 0.35 * (x + 0.3)) / 0.18, 2)) * (x > -0.3);
            if (hull_here) z = std::min(0.0, -0.2 + 0.0875 * (2 - x) + 0.36 * y);
            for (double zc = r.raster.origin.z() + 0.5 * part; zc < z; zc += part)
                wake.pour({x, y, zc}, part, std::min(1.0, (z - zc) / part + 0.5) * part * part * part);
        });
        wake.pour({1.0, 1.2, 0.85}, 0.03, 2.7e-5);  // one drop, far above everything
        for (double t = 0.04; t <= o.duration + 1e-9; t += 0.04) {
            Raster now = wake;
            // The spray sheet: a wall along the chine, as high as the run says.
            columns([&](double x, double y) {
                const double crest = (o.splash + 0.02 * normal(random)) * std::exp(-std::pow((x - 0.5) / 0.5, 2));
                if (std::abs(y - 0.66) < 0.05)
                    for (double zc = 0.5 * part; zc < crest; zc += part) now.pour({x, y, zc}, part, part * part * part);
            });
            r.frames.push_back(now.frame(t));
        }
    }
    r.phases = {{"set-up", 2.5, 2.5}, {"solving", 95, 181}, {"output", 3, 3}};
    r.peak_memory = 412e6;
    r.elements = o.method == "sph" ? 163000 : 74000;
    r.steps = o.method == "sph" ? 2086 : 480;
    r.effects = {{"viscosity", false, false, "Reynolds number 1.8e7: friction is a separate 150 N", "drag 35 %", 0.3},
                 {"air", false, true, "among the particles only on demand", "lift 3 %, drag 10 %", 0}};
    r.state = "finished";
    return r;
}

}  // namespace tw
