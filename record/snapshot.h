#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// Named field for ParaView: `components` values per point or cell.
struct Field {
    std::string name;
    int components = 1;
    std::vector<float> values;  ///< `components` for each particle or point, one after another [SI]
};

/// Particles as a VTKHDF UnstructuredGrid of vertices (ParaView 5.11 and VTK 9.1 open it under the suffix .hdf),
/// atomically. Throws RunError where a field has another number of values than `points` times its components, where
/// HDF5 fails, and where the file cannot be written.
void write_particles(const std::filesystem::path& file, double time, const std::vector<Vec3>& points,
                     const std::vector<Field>& fields);
/// A surface with cell fields as .vtp, atomically. Throws RunError where a field has another number of values than
/// triangles times its components, where VTK fails, and where the file cannot be written.
void write_surface(const std::filesystem::path& file, const Surface& surface, const std::vector<Field>& cell_fields);
/// name.hdf.series / name.vtp.series: the times of a set of files, as ParaView reads them.
/// Files without a name, or with one outside the folder of `file`, and what is no series are left out. Throws
/// InputError where `file` cannot be read.
std::vector<std::pair<std::string, double>> read_series(const std::filesystem::path& file);
/// Atomically; throws RunError where the file cannot be written.
void write_series(const std::filesystem::path& file,
                  const std::vector<std::pair<std::string, double>>& files_and_times);

}  // namespace tw
