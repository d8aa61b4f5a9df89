#pragma once
#include <vtkDataArray.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tw::spray {

/// A time that an OpenFOAM case has written.
struct FoamTime {
    double time = 0;               ///< [s]
    std::filesystem::path folder;  ///< of its fields
};

/// Fields of one time of an OpenFOAM case, read through VTK.
class FoamFields {
public:
    enum class At { cells, points };  ///< points: cells are cut into simple shapes, values carried to their corners
    /// `folder`: of the case. Throws InputError naming it: no mesh there.
    FoamFields(const std::filesystem::path& folder, double time, At at);

    vtkUnstructuredGrid& grid() const { return *grid_; }
    bool has(const char* name) const { return found(name) != nullptr; }
    /// A field of that many components. Throws InputError naming the case, the field and the time: it is not there.
    vtkDataArray& field(const char* name, int components) const;

private:
    vtkDataArray* found(const char* name) const;

    std::filesystem::path folder_;
    double time_;
    At at_;
    std::string complaint_;  ///< VTK's first
    vtkSmartPointer<vtkUnstructuredGrid> grid_;
};

/// The case's folder: RUN/fvm/case of a run, or the folder itself. Throws InputError: no system/controlDict there.
std::filesystem::path foam_case(const std::filesystem::path& run);
/// What the case has written, in the order of time.
std::vector<FoamTime> foam_times(const std::filesystem::path& folder);

}  // namespace tw::spray
