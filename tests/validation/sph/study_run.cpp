#include "study_run.h"

#include <algorithm>

#include "sph_solver/run_sph.h"

namespace tw::test {
namespace {

double share(const RasterSpec& raster, const RasterFrame& frame, int i, int j, int k) {
    const auto [nx, ny, nz] = raster.count;
    return frame.water[static_cast<std::size_t>((k * ny + j) * nx + i)] / 255.0;
}

}  // namespace

StudyRun run_study(const std::string& study, std::optional<double> duration) {
    StudyRun run;
    SceneOverrides overrides;
    overrides.duration = duration;
    run.scene = read_scene(std::filesystem::path(TWINWAKE_SOURCE) / "studies" / (study + ".toml"), overrides);
    const auto folder = std::filesystem::temp_directory_path() / ("twinwake_validation_" + study);
    std::filesystem::remove_all(folder);
    RunOptions options;
    options.folder = folder;
    run_sph(run.scene, options);
    run.record = read_record(folder / "record.h5");
    std::filesystem::remove_all(folder);
    return run;
}

double still_level(const Scene& scene) {
    if (scene.water_blocks.empty()) return 0;
    double top = scene.water_blocks.front().max.z();
    for (const Box& block : scene.water_blocks) top = std::max(top, block.max.z());
    return top;
}

double mean_from(const Table& table, const Column& column, double from) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < table.time.size(); ++i)
        if (table.time[i] >= from) {
            sum += column.values[i];
            ++count;
        }
    return sum / count;
}

std::vector<double> water_columns(const RasterSpec& raster, const RasterFrame& frame) {
    const auto [nx, ny, nz] = raster.count;
    std::vector<double> depth(static_cast<std::size_t>(nx), 0);
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                depth[static_cast<std::size_t>(i)] += share(raster, frame, i, j, k) * raster.spacing / ny;
    return depth;
}

double front_on_floor(const RasterSpec& raster, const RasterFrame& frame) {
    const auto [nx, ny, nz] = raster.count;
    double front = raster.origin.x();
    for (int i = 0; i < nx; ++i) {
        double wet = 0;
        for (int k = 0; k < std::min(nz, 2); ++k)
            for (int j = 0; j < ny; ++j) wet += share(raster, frame, i, j, k) / ny;
        front += std::min(1.0, wet) * raster.spacing;
        if (wet < 0.25) break;
    }
    return front;
}

}  // namespace tw::test
