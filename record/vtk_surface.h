#pragma once
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "meshes/surface.h"

namespace tw {

/// The points and triangles of VTK's surface; other cells are left out.
inline Surface surface_of(vtkPolyData* data) {
    Surface surface;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) surface.points.emplace_back(data->GetPoint(i));
    vtkNew<vtkIdList> corners;
    vtkCellArray* cells = data->GetPolys();
    for (cells->InitTraversal(); cells->GetNextCell(corners);)
        if (corners->GetNumberOfIds() == 3)
            surface.triangles.push_back({static_cast<int>(corners->GetId(0)), static_cast<int>(corners->GetId(1)),
                                         static_cast<int>(corners->GetId(2))});
    return surface;
}

/// The surface as VTK has it, without fields.
inline vtkSmartPointer<vtkPolyData> poly_data_of(const Surface& surface) {
    vtkNew<vtkPoints> points;
    for (const Vec3& p : surface.points) points->InsertNextPoint(p.data());
    vtkNew<vtkCellArray> cells;
    for (const auto& t : surface.triangles) {
        const vtkIdType corners[3] = {t[0], t[1], t[2]};
        cells->InsertNextCell(3, corners);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

}  // namespace tw
