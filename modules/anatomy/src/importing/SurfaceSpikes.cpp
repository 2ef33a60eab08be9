// SPDX-License-Identifier: BSD-3-Clause
#include "importing/SurfaceSpikes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "mesh/Triangles.h"

namespace perilymph::anatomy {
namespace {

constexpr double minSpike = 0.1e-3, spikeOfEdges = 0.8, rimSpikeOfEdges = 1.0;
constexpr double ofOtherCorners = 3.0;  // times the median of the rim: its teeth are no spikes

void raise(std::optional<SurfaceSpike>& highest, const SurfaceSpike& other)
{
  if (!highest || other.height > highest->height) highest = other;
}

}  // namespace

std::optional<SurfaceSpike> highestSpike(const Surface& surface)
{
  // around each corner: its neighbors, once a triangle, and the edges opposite to it
  std::vector<std::vector<int>> neighbors(surface.points.size());
  std::vector<double> edges(surface.points.size(), 0.0);
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto here = static_cast<std::size_t>(t[k]);
      const int a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      neighbors[here].insert(neighbors[here].end(), {a, b});
      edges[here] += (corner(surface, a) - corner(surface, b)).norm();
    }
  std::optional<SurfaceSpike> highest;
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    if (neighbors[i].empty()) continue;
    const Eigen::Vector3d tip = corner(surface, static_cast<int>(i));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int other : neighbors[i]) sum += tip - corner(surface, other);
    const Eigen::Vector3d along = sum.normalized();
    double height = std::numeric_limits<double>::infinity();
    for (const int other : neighbors[i])
      height = std::min(height, (tip - corner(surface, other)).dot(along));
    const double edge = 2.0 * edges[i] / static_cast<double>(neighbors[i].size());
    if (height > std::max(minSpike, spikeOfEdges * edge))
      raise(highest, {static_cast<int>(i), height});
  }
  return highest;
}

std::optional<SurfaceSpike> highestSpike(const Surface& surface, const SurfaceRim& rim)
{
  const std::size_t count = rim.corners.size();
  if (count < 6) return std::nullopt;
  const auto at = [&](std::size_t k) { return corner(surface, rim.corners[k % count]); };
  std::vector<double> offs;
  for (std::size_t k = 0; k < count; ++k) {
    // the cubic through the two corners before and the two after
    const Eigen::Vector3d expected =
        (4.0 * (at(k + count - 1) + at(k + 1)) - (at(k + count - 2) + at(k + 2))) / 6.0;
    offs.push_back((at(k) - expected).norm());
  }
  std::vector<double> sorted = offs;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<long>(count / 2), sorted.end());
  const double usual = ofOtherCorners * sorted[count / 2];
  std::optional<SurfaceSpike> highest;
  for (std::size_t k = 0; k < count; ++k) {
    const double edge =
        0.5 * ((at(k + 1) - at(k + 2)).norm() + (at(k + count - 1) - at(k + count - 2)).norm());
    if (offs[k] > std::max({minSpike, rimSpikeOfEdges * edge, usual}))
      raise(highest, {rim.corners[k], offs[k]});
  }
  return highest;
}

}  // namespace perilymph::anatomy
