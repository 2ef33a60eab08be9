// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

namespace perilymph::imaging {

vtkSmartPointer<vtkPolyData> toPolyData(const anatomy::Surface& surface)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const auto& point : surface.points)
    points->InsertNextPoint(1e3 * point[0], 1e3 * point[1], 1e3 * point[2]);
  const auto triangles = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& triangle : surface.triangles) {
    const vtkIdType corners[3] = {triangle[0], triangle[1], triangle[2]};
    triangles->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

anatomy::Surface fromPolyData(vtkPolyData& data)
{
  anatomy::Surface surface;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    double point[3];
    data.GetPoint(i, point);
    surface.points.push_back({1e-3 * point[0], 1e-3 * point[1], 1e-3 * point[2]});
  }
  vtkCellArray* const cells = data.GetPolys();
  if (!cells) return surface;
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(count, corners) != 0;)
    if (count == 3)
      surface.triangles.push_back({static_cast<int>(corners[0]), static_cast<int>(corners[1]),
                                   static_cast<int>(corners[2])});
  return surface;
}

}  // namespace perilymph::imaging
