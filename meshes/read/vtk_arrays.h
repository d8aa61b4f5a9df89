#pragma once
#include <vtkSmartPointer.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/trial.h"
#include "base/vec3.h"

class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace tw {

/// What a reader of VTK has read, as plain arrays: the polygons of a surface, or the cells of a grid.
struct VtkArrays {
    std::vector<double> points;         ///< x, y, z of each [unit of the file]: 3 times their number
    std::vector<std::int64_t> corners;  ///< of all cells, one after the other; all are among the points
    std::vector<std::int64_t> ends;     ///< of each cell's corners
    std::vector<std::uint8_t> types;    ///< VTK's numbers of the cells; of a surface empty
    struct Values {
        std::string name;
        bool of_points = false;  ///< else of cells
        std::int64_t components = 1;
        std::vector<double> values;  ///< as many for every point, or cell [unit of the file]
    };
    std::vector<Values> values;
    std::string complaint;  ///< VTK's first, of what is not there; empty: none

    std::size_t count() const { return ends.size(); }
    Vec3 point(std::size_t n) const { return {points[3 * n], points[3 * n + 1], points[3 * n + 2]}; }
    std::span<const std::int64_t> cell(std::size_t c) const;
    /// Values of that name with as many components; null: there are none.
    const std::vector<double>* find(const std::string& name, bool of_points, std::int64_t components) const;
};

/// Reads by `read` in a child process, as VTK's readers follow the counts and labels of a file unchecked, and takes
/// over what is sound. VTK stays off the terminal, and works in one thread from here on, in this process too.
/// `every_complaint`: what VTK complains of is refused. Throws InputError that says why nothing can be read, without
/// the file's name: VTK's complaint, cells whose corners are no points, a crash, no end.
VtkArrays read_by_vtk(const std::function<vtkSmartPointer<vtkPointSet>()>& read, bool every_complaint,
                      const TrialLimits& limits = {});

vtkSmartPointer<vtkPolyData> surface_of(const VtkArrays& arrays);
/// With the values. A polyhedron becomes the convex set of its corners.
vtkSmartPointer<vtkUnstructuredGrid> grid_of(const VtkArrays& arrays);

}  // namespace tw
