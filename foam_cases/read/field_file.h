#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/vec3.h"

namespace tw {

/// Internal values of a volume field as OpenFOAM writes it: ascii or binary, single or double precision, uniform or one
/// value per cell. `components` is 1 (volScalarField) or 3 (volVectorField).
struct FieldFile {
    int components = 1;
    bool uniform = false;
    std::vector<double> values;  ///< one tuple when uniform [unit of the field]

    std::size_t cells() const { return values.size() / static_cast<std::size_t>(components); }
    double scalar(std::size_t cell) const { return values[uniform ? 0 : cell]; }
    Vec3 vector(std::size_t cell) const {
        const double* v = &values[uniform ? 0 : 3 * cell];
        return {v[0], v[1], v[2]};
    }
};
/// Throws RunError naming the file: not there, another class, cut off.
FieldFile read_field(const std::filesystem::path& file);

/// The field of cell volumes in a time folder: V, or Vc as openfoam.org writes it from 12 on.
std::string cell_volumes_in(const std::filesystem::path& time_folder);

}  // namespace tw
