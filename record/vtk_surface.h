#pragma once
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

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

}  // namespace tw
