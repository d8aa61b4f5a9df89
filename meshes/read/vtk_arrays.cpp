#include "meshes/read/vtk_arrays.h"

#include <SMP/Common/vtkSMPToolsAPI.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstring>

#include "base/errors.h"
#include "meshes/read/vtk_complaints.h"

namespace tw {
namespace {

/// One order of the parts for both ways.
template <class Use>
void each_part(auto& arrays, Use use) {
    use(arrays.points), use(arrays.corners), use(arrays.ends), use(arrays.types), use(arrays.complaint);
}

template <class List>
void put(std::string& bytes, const List& list) {
    const std::uint64_t n = list.size();
    bytes.append(reinterpret_cast<const char*>(&n), sizeof n);
    bytes.append(reinterpret_cast<const char*>(list.data()), n * sizeof(typename List::value_type));
}
template <class List>
void take(std::string_view& bytes, List& list) {
    std::uint64_t n = 0;
    std::memcpy(&n, bytes.data(), sizeof n);
    bytes.remove_prefix(sizeof n);
    list.resize(n);
    if (n > 0) std::memcpy(list.data(), bytes.data(), n * sizeof(typename List::value_type));
    bytes.remove_prefix(n * sizeof(typename List::value_type));
}

std::string packed(const VtkArrays& arrays) {
    std::string bytes;
    each_part(arrays, [&](const auto& list) { put(bytes, list); });
    for (const VtkArrays::Values& v : arrays.values) {
        put(bytes, v.name), put(bytes, std::vector<std::int64_t>{v.of_points ? 1 : 0, v.components});
        put(bytes, v.values);
    }
    return bytes;
}
VtkArrays unpacked(std::string_view bytes) {
    VtkArrays arrays;
    each_part(arrays, [&](auto& list) { take(bytes, list); });
    while (!bytes.empty()) {
        VtkArrays::Values& v = arrays.values.emplace_back();
        std::vector<std::int64_t> kind;
        take(bytes, v.name), take(bytes, kind), take(bytes, v.values);
        v.of_points = kind[0] != 0, v.components = kind[1];
    }
    return arrays;
}

void take_values(VtkArrays& arrays, vtkDataSetAttributes* of, bool of_points, std::size_t count) {
    for (int a = 0; a < of->GetNumberOfArrays(); ++a) {
        vtkDataArray* from = of->GetArray(a);
        if (from == nullptr || from->GetName() == nullptr || from->GetNumberOfComponents() < 1) continue;
        if (from->GetNumberOfTuples() != static_cast<vtkIdType>(count)) continue;
        VtkArrays::Values& v = arrays.values.emplace_back();
        v.name = from->GetName(), v.of_points = of_points, v.components = from->GetNumberOfComponents();
        v.values.resize(count * static_cast<std::size_t>(v.components));
        for (std::size_t i = 0; i < count; ++i)
            from->GetTuple(static_cast<vtkIdType>(i), &v.values[i * static_cast<std::size_t>(v.components)]);
    }
}

VtkArrays arrays_of(vtkPointSet& data) {
    VtkArrays arrays;
    const vtkIdType points = data.GetNumberOfPoints();
    for (vtkIdType i = 0; i < points; ++i)
        arrays.points.insert(arrays.points.end(), data.GetPoint(i), data.GetPoint(i) + 3);
    auto* grid = vtkUnstructuredGrid::SafeDownCast(&data);
    auto* surface = vtkPolyData::SafeDownCast(&data);
    vtkCellArray* cells = grid != nullptr ? grid->GetCells() : surface->GetPolys();
    if (cells != nullptr && !cells->IsValid()) throw InputError("its cells are inconsistent");
    for (vtkIdType c = 0; cells != nullptr && c < cells->GetNumberOfCells(); ++c) {
        vtkIdType n = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCellAtId(c, n, ids);
        for (vtkIdType k = 0; k < n; ++k)
            if (ids[k] < 0 || ids[k] >= points)
                throw InputError("cell " + std::to_string(c) + " uses point " + std::to_string(ids[k]) + " of " +
                                 std::to_string(points));
        arrays.corners.insert(arrays.corners.end(), ids, ids + n);
        arrays.ends.push_back(static_cast<std::int64_t>(arrays.corners.size()));
        if (grid != nullptr) arrays.types.push_back(static_cast<std::uint8_t>(grid->GetCellType(c)));
    }
    take_values(arrays, data.GetPointData(), true, arrays.points.size() / 3);
    if (data.GetNumberOfCells() == static_cast<vtkIdType>(arrays.count()))
        take_values(arrays, data.GetCellData(), false, arrays.count());
    return arrays;
}

vtkSmartPointer<vtkPoints> points_of(const VtkArrays& arrays) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    for (std::size_t n = 0; 3 * n < arrays.points.size(); ++n) points->InsertNextPoint(&arrays.points[3 * n]);
    return points;
}
vtkSmartPointer<vtkCellArray> cells_of(const VtkArrays& arrays) {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (std::size_t c = 0; c < arrays.count(); ++c) {
        const std::vector<vtkIdType> corners(arrays.cell(c).begin(), arrays.cell(c).end());
        cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    }
    return cells;
}

}  // namespace

std::span<const std::int64_t> VtkArrays::cell(std::size_t c) const {
    const auto begin = static_cast<std::size_t>(c > 0 ? ends[c - 1] : 0);
    return std::span(corners).subspan(begin, static_cast<std::size_t>(ends[c]) - begin);
}

const std::vector<double>* VtkArrays::find(const std::string& name, bool of_points, std::int64_t components) const {
    const auto found = std::ranges::find_if(values, [&](const Values& v) {
        return v.name == name && v.of_points == of_points && v.components == components;
    });
    return found == values.end() ? nullptr : &found->values;
}

VtkArrays read_by_vtk(const std::function<vtkSmartPointer<vtkPointSet>()>& read, bool every_complaint,
                      const TrialLimits& limits) {
    // A child of a process with threads of VTK waits for ever for what one of them held when it was forked.
    vtk::detail::smp::vtkSMPToolsAPI::GetInstance().SetBackend("Sequential");
    return unpacked(answer_of_trial(
        [&] {
            const VtkComplaints complaints;
            const vtkSmartPointer<vtkPointSet> data = read();
            const std::string complaint = complaints.first();
            if (every_complaint && !complaint.empty()) throw InputError("VTK says: " + complaint);
            if (!data) throw InputError(complaint.empty() ? "VTK finds nothing in it" : "VTK says: " + complaint);
            VtkArrays arrays = arrays_of(*data);
            arrays.complaint = complaint;
            return packed(arrays);
        },
        limits));
}

vtkSmartPointer<vtkPolyData> surface_of(const VtkArrays& arrays) {
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(points_of(arrays));
    surface->SetPolys(cells_of(arrays));
    return surface;
}

vtkSmartPointer<vtkUnstructuredGrid> grid_of(const VtkArrays& arrays) {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(points_of(arrays));
    vtkNew<vtkUnsignedCharArray> types;
    // A polyhedron's corners are here without its faces, and VTK would take them for a list of faces.
    for (const std::uint8_t type : arrays.types)
        types->InsertNextValue(type == VTK_POLYHEDRON ? std::uint8_t{VTK_CONVEX_POINT_SET} : type);
    grid->SetCells(types, cells_of(arrays));
    for (const VtkArrays::Values& v : arrays.values) {
        vtkNew<vtkDoubleArray> array;
        array->SetName(v.name.c_str());
        array->SetNumberOfComponents(static_cast<int>(v.components));
        array->SetNumberOfTuples(static_cast<vtkIdType>(v.values.size()) / v.components);
        std::ranges::copy(v.values, array->GetPointer(0));
        vtkDataSetAttributes* of = grid->GetCellData();
        if (v.of_points) of = grid->GetPointData();
        of->AddArray(array);
    }
    return grid;
}

}  // namespace tw
