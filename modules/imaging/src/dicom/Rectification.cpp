// SPDX-License-Identifier: BSD-3-Clause
#include "Rectification.h"

#include <vtkDICOMCTRectifier.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkImageImport.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "../VtkErrorCollector.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::imaging {

namespace {

/// Marks the corners that a tilt leaves empty, which VTK fills with 0, the intensity of water:
/// voxels whose centers lie beyond the borders of the sheared grid, or at its unmeasured voxels.
void markUnmeasured(Grid& straight, const Grid& sheared)
{
  constexpr double border = 0.5 - 1e-6;  // in voxels
  const std::array<int, 3>& size = sheared.size;
  const Eigen::Matrix4d sheared_IJ = sheared.lps_PI.inverse() * straight.lps_PI;
  std::size_t at = 0;
  for (int k = 0; k < straight.size[2]; ++k)
    for (int j = 0; j < straight.size[1]; ++j)
      for (int i = 0; i < straight.size[0]; ++i, ++at) {
        const Eigen::Vector4d index = sheared_IJ * Eigen::Vector4d(i, j, k, 1.0);
        std::size_t nearest = 0, stride = 1;
        bool isBeyond = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double along = index[static_cast<Eigen::Index>(axis)];
          isBeyond = isBeyond || along < -border || along > size[axis] - 1 + border;
          nearest += stride *
                     static_cast<std::size_t>(std::clamp(std::lround(along), 0L, size[axis] - 1L));
          stride *= static_cast<std::size_t>(size[axis]);
        }
        if (isBeyond || sheared.voxels[nearest] == ct::unmeasured)
          straight.voxels[at] = ct::unmeasured;
      }
}

}  // namespace

Result<Grid> rectified(const Grid& sheared)
{
  // VTK's image carries the spacing, its matrix directions: the third is as long as the shear
  // makes it.
  const Eigen::Matrix3d axes = sheared.lps_PI.topLeftCorner<3, 3>();
  Eigen::Vector3d spacing(axes.col(0).norm(), axes.col(1).norm(), 0.0);
  const Eigen::Vector3d normal = axes.col(0).cross(axes.col(1)).normalized();
  spacing.z() = normal.dot(axes.col(2));
  const auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      matrix->SetElement(row, column, axes(row, column) / spacing[column]);
    matrix->SetElement(row, 3, sheared.lps_PI(row, 3));
  }

  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(sheared.size.data());
  image->SetSpacing(spacing.data());
  image->AllocateScalars(VTK_SHORT, 1);
  std::transform(sheared.voxels.begin(), sheared.voxels.end(),
                 static_cast<std::int16_t*>(image->GetScalarPointer()), ct::asAir);

  const auto complaints = vtkSmartPointer<ErrorCollector>::New();
  const auto rectifier = vtkSmartPointer<vtkDICOMCTRectifier>::New();
  complaints->listenTo({rectifier, rectifier->GetExecutive()});
  rectifier->SetInputData(image);
  rectifier->SetVolumeMatrix(matrix);
  rectifier->Update();
  vtkImageData& output = *rectifier->GetOutput();
  if (complaints->isAny || output.GetScalarType() != VTK_SHORT ||
      output.GetNumberOfScalarComponents() != 1)
    return Error{
        "The tilted gantry's volume could not be resampled to right angles. Export it reformatted "
        "without tilt."};

  Grid straight;
  const int* const extent = output.GetExtent();
  const vtkMatrix4x4& directions = *rectifier->GetRectifiedMatrix();
  const double* const outSpacing = output.GetSpacing();
  const double* const outOrigin = output.GetOrigin();
  Eigen::Matrix4d lps_PX;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      lps_PX(row, column) = directions.GetElement(row, column);
  Eigen::Matrix4d image_XI = Eigen::Matrix4d::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    straight.size[static_cast<std::size_t>(axis)] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    image_XI(axis, axis) = outSpacing[axis];
    image_XI(axis, 3) = outOrigin[axis] + extent[2 * axis] * outSpacing[axis];
  }
  straight.lps_PI = lps_PX * image_XI;
  const auto* const first = static_cast<const std::int16_t*>(output.GetScalarPointer());
  straight.voxels.assign(first, first + output.GetNumberOfPoints());
  markUnmeasured(straight, sheared);
  return straight;
}

}  // namespace perilymph::imaging
