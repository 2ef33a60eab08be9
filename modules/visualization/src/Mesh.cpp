// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

namespace perilymph::visualization {

Mesh::Mesh(Coloring coloring)
{
  points_->SetNumberOfComponents(3);
  normals_->SetNumberOfComponents(3);
  colors_->SetNumberOfComponents(4);
  places_->SetData(points_);
  data_->GetPointData()->SetNormals(normals_);
  data_->SetPolys(triangles_);
  mapper_->SetInputData(data_);
  // Millimeters near the origin: no shift needed, and no pass over the points to determine it.
  mapper_->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  mapper_->SetScalarVisibility(coloring == Coloring::perPoint);
  if (coloring == Coloring::perPoint) {
    data_->GetPointData()->SetScalars(colors_);
    mapper_->SetScalarModeToUsePointData();
    mapper_->SetColorModeToDirectScalars();
  }
  actor_->SetMapper(mapper_);
  vtkProperty& look = *actor_->GetProperty();
  look.SetInterpolationToPhong();
  look.SetAmbient(0.25);
  look.SetDiffuse(0.75);
}

Mesh::~Mesh() = default;

void Mesh::shape(int points, const std::vector<Triangle>& triangles)
{
  points_->SetNumberOfTuples(points);
  normals_->SetNumberOfTuples(points);
  points_->FillValue(0.0f);
  normals_->FillValue(0.0f);
  if (data_->GetPointData()->GetScalars() != nullptr) {
    colors_->SetNumberOfTuples(points);
    colors_->FillValue(255);
  }
  connect(triangles);
  pointsChanged();
  colorsChanged();
}

void Mesh::connect(const std::vector<Triangle>& triangles)
{
  triangles_->Reset();
  for (const Triangle& triangle : triangles) {
    const vtkIdType corners[3] = {triangle[0], triangle[1], triangle[2]};
    triangles_->InsertNextCell(3, corners);
  }
  triangles_->Modified();
  // For points without triangles VTK would stop a timer that it never started, with a warning each
  // time.
  data_->SetPoints(triangles.empty() ? nullptr : places_.Get());
  data_->Modified();
}

vtkSmartPointer<vtkActor> Mesh::anotherActor() const
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper_);
  actor->GetProperty()->DeepCopy(actor_->GetProperty());
  return actor;
}

int Mesh::points() const { return static_cast<int>(points_->GetNumberOfTuples()); }

Eigen::Map<Eigen::Vector3f> Mesh::point(int index)
{
  return Eigen::Map<Eigen::Vector3f>(points_->GetPointer(3 * index));
}

Eigen::Map<Eigen::Vector3f> Mesh::normal(int index)
{
  return Eigen::Map<Eigen::Vector3f>(normals_->GetPointer(3 * index));
}

void Mesh::setColor(int index, const Rgba& color)
{
  unsigned char* place = colors_->GetPointer(4 * index);
  for (std::size_t i = 0; i < 4; ++i) place[i] = color[i];
}

void Mesh::pointsChanged()
{
  points_->Modified();
  normals_->Modified();
  places_->Modified();
  data_->Modified();
}

void Mesh::colorsChanged()
{
  colors_->Modified();
  data_->Modified();
}

void Mesh::paint(const Rgba& color)
{
  vtkProperty& look = *actor_->GetProperty();
  look.SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  look.SetOpacity(color[3] / 255.0);
}

}  // namespace perilymph::visualization
