#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "record/run_record.h"
#include "scene/scene.h"

namespace tw::test {

/// A study's scene, run by the SPH solver into a folder of its own, and the record it left on disk.
struct StudyRun {
    Scene scene;
    RunRecord record;
    double dp() const { return scene.resolution.near_hull; }
};
/// `study`: name of a file in studies/, without .toml; `duration` [s] in place of the study's own.
StudyRun run_study(const std::string& study, std::optional<double> duration = {});

/// Elevation of the water at rest [m].
double still_level(const Scene& scene);
/// Mean over the times from `from` on; NaN values spoil it.
double mean_from(const Table& table, const Column& column, double from);

/// Along x: water standing in the raster, averaged over y [m].
std::vector<double> water_columns(const RasterSpec& raster, const RasterFrame& frame);

/// Farthest place the water on the floor has reached [m]: the end of the unbroken wet run of the two lowest voxel layers
/// (the tongue is a particle or two thick), a partly filled last voxel counted by its share.
double front_on_floor(const RasterSpec& raster, const RasterFrame& frame);

}  // namespace tw::test
