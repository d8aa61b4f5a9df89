// How long reading and comparing two large runs takes, and making their report: records as 10^6 particles or cells
// leave them (raster of two spacings), 200 frames, 10^4 steps.
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <filesystem>

#include "base/numbers.h"
#include "compare/compare.h"
#include "meshes/generate.h"
#include "record/raster.h"
#include "record/run_record.h"

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double peak_megabytes() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return static_cast<double>(use.ru_maxrss) / 1e3;
}

/// A planing half model whose wake moves from frame to frame. Every number in it is invented.
tw::RunRecord large_run(const std::string& method) {
    constexpr int frames = 200, steps = 10000;
    constexpr double duration = 2;
    tw::RunRecord r;
    r.attributes = {{"method", method},   {"title", "Benchmark"},   {"scene_hash", "s"},         {"hull_hash", "h"},
                    {"motion", "stream"}, {"symmetry_factor", "2"}, {"hull_source", "prismatic"}};
    r.numbers = {{"speed", 8},       {"length", 4},       {"beam", 1},       {"draft", 0.2},   {"duration", duration},
                 {"mean_from", 0.5}, {"near_hull", 0.03}, {"density", 1000}, {"gravity", 9.81}};
    r.hull = tw::posed(tw::make_hull("prismatic", {{"length", 4.0}, {"beam", 1.0}}), {.trim = 0.087, .draft = 0.2});
    const auto triangles = r.hull.triangles.size();
    r.hull_pressure.assign(triangles, 1000.0f), r.hull_wet.assign(triangles, 1.0f);
    tw::Table& forces = r.table("forces");
    for (const char* name : {"fx", "fz", "fx_pressure", "fz_pressure"}) forces.column(name, "N");
    forces.column("my", "N m");
    for (int k = 0; k < steps; ++k) {
        const double t = duration * k / steps;
        forces.time.push_back(t);
        for (tw::Column& c : forces.columns) c.values.push_back(2800 + 30 * std::sin(917 * t) + 20 * std::sin(331 * t));
    }
    r.raster = {{-3, 0, -1.6}, 0.06, {125, 34, 50}};  // half of a box that holds 10^6 particles of 30 mm
    for (int k = 1; k <= frames; ++k) {
        tw::Raster raster(r.raster);
        const double d = r.raster.voxel, phase = 2 * tw::pi * k / 40;
        for (int i = 0; i < r.raster.count[0]; ++i)
            for (int j = 0; j < r.raster.count[1]; ++j) {
                const double x = r.raster.origin.x() + (i + 0.5) * d, y = (j + 0.5) * d;
                const double z = 0.1 * std::sin(3 * x + 2 * y - phase);
                for (double zc = r.raster.origin.z() + 0.5 * d; zc < z; zc += d) raster.pour({x, y, zc}, d, d * d * d);
            }
        r.frames.push_back(raster.frame(duration * k / frames));
    }
    r.phases = {{"solving", 1000, 2000}};
    r.elements = 1e6, r.steps = steps, r.state = "finished";
    return r;
}

}  // namespace

int main() {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "twinwake_bench_compare";
    std::filesystem::create_directories(folder);
    for (const char* method : {"sph", "fvm"})
        tw::write_record(folder / (std::string(method) + ".h5"), large_run(method));
    const double made = peak_megabytes(), start = now();
    std::vector<tw::RunRecord> records;
    for (const char* method : {"sph", "fvm"})
        records.push_back(tw::read_record(folder / (std::string(method) + ".h5")));
    const double read = now();
    const tw::Comparison comparison = tw::compare_records(std::move(records));
    const double compared = now();
    const tw::ReportFiles files = tw::write_report(comparison, folder);
    const double written = now();
    fmt::print(
        "| step | time [s] |\n|---|---|\n| reading two records | {:.2f} |\n| comparing | {:.2f} |\n| report, pictures "
        "and 3-D view in it | {:.2f} |\n| all | {:.2f} |\n\nreport {:.1f} MB; peak memory {:.0f} MB (making "
        "the records {:.0f} MB)\n",
        read - start, compared - read, written - compared, written - start,
        static_cast<double>(std::filesystem::file_size(files.html)) / 1e6, peak_megabytes(), made);
    std::filesystem::remove_all(folder);
}
