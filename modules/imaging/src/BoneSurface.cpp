// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/BoneSurface.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "PolyData.h"

namespace perilymph::imaging {
namespace {

constexpr std::size_t bins = 128, fewVoxels = 100'000;
constexpr double headFrom_mm = 60.0;      // a larger volume shows much soft tissue, too (choice)
constexpr double wholeSteps = 110.0;      // along the longest edge of a whole volume (choice)
constexpr int maxSamples = 200;           // along an edge of the grid
constexpr std::size_t fewTriangles = 60;  // of a piece that is noise (choice)

/// Where P begins in the grid of samples, and how many there are.
struct Grid {
  Eigen::Vector3d origin_P;
  std::array<int, 3> size;
  double step_mm;
};

/// The ball's box, as far as the volume reaches, with one sample around it.
Grid gridOf(const ct::CtVolume& volume, const BoneRequest& request)
{
  const auto& size = volume.size();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d index((corner & 1) != 0 ? size[0] - 1 : 0,
                                (corner & 2) != 0 ? size[1] - 1 : 0,
                                (corner & 4) != 0 ? size[2] - 1 : 0);
    low = low.cwiseMin(volume.toLps(index));
    high = high.cwiseMax(volume.toLps(index));
  }
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(request.radius_mm);
  low = low.cwiseMax(request.center_P - reach);
  high = high.cwiseMin(request.center_P + reach);
  Grid grid{low, {}, std::max(request.step_mm, (high - low).maxCoeff() / (maxSamples - 3))};
  grid.origin_P -= Eigen::Vector3d::Constant(grid.step_mm);
  for (int axis = 0; axis < 3; ++axis)
    grid.size[static_cast<std::size_t>(axis)] =
        high[axis] > low[axis] ? static_cast<int>(std::ceil((high - low)[axis] / grid.step_mm)) + 3
                               : 0;
  return grid;
}

/// Intensity above the level; falls below zero where the ball or the volume ends.
class BoneField {
public:
  BoneField(const ct::CtVolume& volume, const BoneRequest& request, double step_mm)
      : volume_(volume),
        request_(request),
        slope_(request.contrast / step_mm),
        spacing_mm_(volume.spacing_mm())
  {
    for (int axis = 0; axis < 3; ++axis)
      last_[axis] = volume.size()[static_cast<std::size_t>(axis)] - 1.0;
    const double aside = 0.25 * step_mm;
    for (int k = 0; k < 8; ++k)
      around_[static_cast<std::size_t>(k)] = {(k & 1) != 0 ? aside : -aside,
                                              (k & 2) != 0 ? aside : -aside,
                                              (k & 4) != 0 ? aside : -aside};
  }

  float at(const Eigen::Vector3d& point_P) const
  {
    const Eigen::Vector3d index = volume_.toIndex(point_P);
    const double inside_mm = std::min({index.cwiseProduct(spacing_mm_).minCoeff(),
                                       (last_ - index).cwiseProduct(spacing_mm_).minCoeff(),
                                       request_.radius_mm - (point_P - request_.center_P).norm()});
    const double border = slope_ * inside_mm;
    if (border < -request_.contrast) return static_cast<float>(border);
    double sum = 0.0;
    for (const Eigen::Vector3d& aside : around_) {
      const auto value = volume_.sample(point_P + aside);
      sum += value ? *value - request_.level : -request_.contrast;
    }
    return static_cast<float>(std::min(sum / double(around_.size()), border));
  }

private:
  const ct::CtVolume& volume_;
  const BoneRequest& request_;
  double slope_;
  Eigen::Vector3d spacing_mm_, last_;
  std::array<Eigen::Vector3d, 8> around_;
};

/// The pieces of a surface that have many triangles.
anatomy::Surface withoutCrumbs(const anatomy::Surface& surface)
{
  std::vector<int> parent(surface.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int point) {
    while (parent[static_cast<std::size_t>(point)] != point)
      point = parent[static_cast<std::size_t>(point)] =
          parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(point)])];
    return point;
  };
  for (const auto& [a, b, c] : surface.triangles) {
    parent[static_cast<std::size_t>(root(b))] = root(a);
    parent[static_cast<std::size_t>(root(c))] = root(a);
  }
  std::vector<std::size_t> count(surface.points.size(), 0);
  for (const auto& corners : surface.triangles) ++count[static_cast<std::size_t>(root(corners[0]))];
  anatomy::Surface kept;
  std::vector<int> names(surface.points.size(), -1);
  for (const auto& corners : surface.triangles) {
    if (count[static_cast<std::size_t>(root(corners[0]))] < fewTriangles) continue;
    std::array<int, 3> named{};
    for (std::size_t k = 0; k < 3; ++k) {
      int& name = names[static_cast<std::size_t>(corners[k])];
      if (name < 0) {
        name = static_cast<int>(kept.points.size());
        kept.points.push_back(surface.points[static_cast<std::size_t>(corners[k])]);
      }
      named[k] = name;
    }
    kept.triangles.push_back(named);
  }
  return kept;
}

/// Darkest and brightest voxels, without the extremes of noise and metal.
std::array<double, 2> rangeOf(std::vector<double>& some)
{
  const auto at = [&some](double part) {
    const auto place = some.begin() + static_cast<std::ptrdiff_t>(part * double(some.size() - 1));
    std::nth_element(some.begin(), place, some.end());
    return *place;
  };
  return {at(0.01), at(0.99)};
}

/// Lengths of a volume's edges [mm].
Eigen::Vector3d extentOf(const ct::CtVolume& volume)
{
  const auto& size = volume.size();
  return volume.spacing_mm().cwiseProduct(Eigen::Vector3d(size[0], size[1], size[2]));
}

std::vector<double> someVoxels(const ct::CtVolume& volume)
{
  const auto voxels = volume.voxels();
  std::vector<double> some;
  for (std::size_t k = 0; k < voxels.size();
       k += std::max<std::size_t>(1, voxels.size() / fewVoxels))
    if (voxels[k] != ct::unmeasured) some.push_back(voxels[k]);
  return some;
}

}  // namespace

double boneLevelOf(const ct::CtVolume& volume)
{
  std::vector<double> some = someVoxels(volume);
  if (some.size() < 2) return 0.0;
  const auto [low, high] = rangeOf(some);
  if (!(high > low)) return high + 1.0;  // nothing stands out
  // sums of the histogram before each bin: count and first moment
  std::array<double, bins + 1> count{}, moment{};
  for (const double value : some) {
    const double part = std::clamp((value - low) / (high - low), 0.0, 1.0);
    const auto bin = std::min(bins - 1, static_cast<std::size_t>(part * double(bins)));
    count[bin + 1] += 1.0;
    moment[bin + 1] += double(bin);
  }
  std::partial_sum(count.begin(), count.end(), count.begin());
  std::partial_sum(moment.begin(), moment.end(), moment.begin());
  // the variance between the classes is largest where that within them is least
  const auto between = [&](std::size_t from, std::size_t to) {
    const double n = count[to] - count[from], sum = moment[to] - moment[from];
    return n > 0.0 ? sum * sum / n : 0.0;
  };
  double best = -1.0;
  std::size_t threshold = bins / 2;
  const auto consider = [&](std::size_t first, std::size_t second) {
    const double now = between(0, first) + between(first, second) + between(second, bins);
    if (now <= best) return;
    best = now;
    threshold = second;
  };
  const bool hasSoftTissue = extentOf(volume).maxCoeff() > headFrom_mm;
  for (std::size_t second = 1; second < bins; ++second) {
    if (!hasSoftTissue) consider(0, second);
    for (std::size_t first = 1; hasSoftTissue && first < second; ++first) consider(first, second);
  }
  return low + (high - low) * double(threshold) / double(bins);
}

BoneRequest wholeBone(const ct::CtVolume& volume)
{
  std::vector<double> some = someVoxels(volume);
  const auto range = some.size() < 2 ? std::array<double, 2>{0.0, 1.0} : rangeOf(some);
  const Eigen::Vector3d extent = extentOf(volume);
  BoneRequest request;
  request.center_P = volume.center_P();
  request.radius_mm = 0.5 * extent.norm() + volume.spacing_mm().maxCoeff();
  request.level = boneLevelOf(volume);
  request.contrast = std::max(1.0, 0.5 * (range[1] - range[0]));
  request.step_mm = std::max(volume.spacing_mm().minCoeff(), extent.maxCoeff() / wholeSteps);
  return request;
}

anatomy::Surface boneSurface(const ct::CtVolume& volume, const BoneRequest& request)
{
  const Grid grid = gridOf(volume, request);
  const auto [nx, ny, nz] = grid.size;
  if (nx == 0 || ny == 0 || nz == 0) return {};
  const BoneField field(volume, request, grid.step_mm);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfTuples(vtkIdType{nx} * ny * nz);
  float* place = values->GetPointer(0);
  for (int k = 0; k < nz; ++k) {
    if (request.stop.stop_requested()) return {};
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        *place++ = field.at(grid.origin_P + grid.step_mm * Eigen::Vector3d(i, j, k));
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(nx, ny, nz);
  image->SetSpacing(grid.step_mm, grid.step_mm, grid.step_mm);
  image->SetOrigin(grid.origin_P.x(), grid.origin_P.y(), grid.origin_P.z());
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.0);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  return withoutCrumbs(fromPolyData(*edges->GetOutput()));
}

}  // namespace perilymph::imaging
