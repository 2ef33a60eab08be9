// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/PlaneSampler.h"

#include <vtkImageData.h>
#include <vtkImageReslice.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "perilymph/foundation/Quantile.h"
#include "volume/imageOf.h"

namespace perilymph::imaging {

namespace {

constexpr std::int16_t outside = std::numeric_limits<std::int16_t>::min();

/// From pixels (column, row, layer) to voxel indices.
Eigen::Matrix4d indexFromPixel(const ct::CtVolume& volume, const PlanePicture& picture,
                               double layer_mm)
{
  const ct::ViewPlane& plane = picture.plane;
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.block<3, 1>(0, 0) = picture.pixel_mm * plane.right_P;
  lps.block<3, 1>(0, 1) = picture.pixel_mm * plane.down_P;
  lps.block<3, 1>(0, 2) = layer_mm * plane.away_P();
  lps.block<3, 1>(0, 3) = plane.center_P -
                          0.5 * (picture.width - 1) * picture.pixel_mm * plane.right_P -
                          0.5 * (picture.height - 1) * picture.pixel_mm * plane.down_P;
  return volume.lpsFromIndex().inverse() * lps;
}

}  // namespace

GrayWindow wholeWindow(const ct::CtVolume& volume)
{
  const auto voxels = volume.voxels();
  const std::size_t step = std::max<std::size_t>(1, voxels.size() / 100'000);
  std::vector<double> some;
  for (std::size_t k = 0; k < voxels.size(); k += step)
    if (voxels[k] != ct::unmeasured) some.push_back(voxels[k]);
  if (some.empty()) return {0.0, 1.0};
  const double low = quantile(some, 0.01), high = quantile(some, 0.99);
  return {0.5 * (low + high), std::max(1.0, high - low)};
}

struct PlaneSampler::Pipeline {
  vtkNew<vtkImageReslice> reslice;
  vtkNew<vtkMatrix4x4> axes;
  std::vector<std::uint8_t> gray;
};

PlaneSampler::PlaneSampler(std::shared_ptr<const ct::CtVolume> volume)
    : volume_(std::move(volume)), pipeline_(std::make_unique<Pipeline>())
{
  vtkImageReslice& reslice = *pipeline_->reslice;
  reslice.SetInputData(imageOf(*volume_));
  reslice.SetInterpolationModeToLinear();
  reslice.SetBackgroundLevel(outside);
  reslice.SetOutputOrigin(0, 0, 0);
  reslice.SetOutputSpacing(1, 1, 1);
  reslice.SetOutputDimensionality(2);
}

PlaneSampler::~PlaneSampler() = default;

std::span<const std::uint8_t> PlaneSampler::sample(const PlanePicture& picture)
{
  if (picture.width < 1 || picture.height < 1) return {};
  // layers half a voxel apart, so that no voxel is missed
  const double fine_mm = 0.5 * volume_->spacing_mm().minCoeff();
  const int layers =
      std::clamp(1 + int(std::ceil(picture.thickness_mm / std::max(fine_mm, 1e-3))), 1, 64);
  const double layer_mm = layers > 1 ? picture.thickness_mm / (layers - 1) : 1.0;
  const Eigen::Matrix4d matrix = indexFromPixel(*volume_, picture, layer_mm);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      pipeline_->axes->SetElement(row, column, matrix(row, column));
  vtkImageReslice& reslice = *pipeline_->reslice;
  reslice.SetResliceAxes(pipeline_->axes);
  reslice.SetOutputExtent(0, picture.width - 1, 0, picture.height - 1, 0, 0);
  reslice.SetSlabNumberOfSlices(layers);
  if (picture.projection == Projection::maximum)
    reslice.SetSlabModeToMax();
  else
    reslice.SetSlabModeToMean();
  reslice.Modified();
  reslice.Update();

  const auto count =
      static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  pipeline_->gray.resize(count);
  const auto* const values =
      static_cast<const std::int16_t*>(reslice.GetOutput()->GetScalarPointer());
  const double scale = 255.0 / std::max(picture.window.width, 1e-6);
  const double black = picture.window.center - 0.5 * picture.window.width;
  std::transform(values, values + count, pipeline_->gray.begin(), [=](std::int16_t value) {
    if (value == outside) return std::uint8_t{0};
    return static_cast<std::uint8_t>(std::clamp(scale * (value - black), 0.0, 255.0) + 0.5);
  });
  return pipeline_->gray;
}

}  // namespace perilymph::imaging
