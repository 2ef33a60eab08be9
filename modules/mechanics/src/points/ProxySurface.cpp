// SPDX-License-Identifier: BSD-3-Clause
#include "points/ProxySurface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "perilymph/anatomy/SurfaceDistance.h"
#include "perilymph/foundation/Hash.h"
#include "points/HalfSpaces.h"

namespace perilymph::mechanics {
namespace {

constexpr double usualCell = 0.4e-3;      // [m]; about as long as the triangles of a haptic surface
constexpr int maxCells = 64;              // along each axis
constexpr double largestSurface = 50e-3;  // [m]; a cochlea is 10 mm wide
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

Eigen::Vector3d cornerOf(const anatomy::Surface& surface, int index)
{
  const auto& p = surface.points.at(static_cast<std::size_t>(index));
  for (const double value : p)
    if (!std::isfinite(value))
      throw std::invalid_argument("A corner of the haptic surface is not a number.");
  return {p[0], p[1], p[2]};
}

}  // namespace

ProxySurface::ProxySurface(const anatomy::Surface& surface, double maxRadius)
    : maxRadius_(maxRadius)
{
  Hash hash;
  hash.add(maxRadius);
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-1.0);
  low_W_ = Eigen::Vector3d::Constant(1.0);
  for (const auto& t : surface.triangles) {
    Triangle triangle{cornerOf(surface, t[0]),
                      cornerOf(surface, t[1]),
                      cornerOf(surface, t[2]),
                      Eigen::Vector3d::Zero(),
                      t,
                      {-1, -1, -1}};
    const Eigen::Vector3d outward = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
    const double size = outward.norm();
    if (!(size > 0.0)) continue;  // a degenerate triangle constrains nothing beyond its neighbors
    triangle.inward = -outward / size;
    for (const Eigen::Vector3d* corner : {&triangle.a, &triangle.b, &triangle.c})
      for (int axis = 0; axis < 3; ++axis) {
        hash.add((*corner)[axis]);
        low_W_[axis] = std::min(low_W_[axis], (*corner)[axis]);
        high[axis] = std::max(high[axis], (*corner)[axis]);
      }
    triangles_.push_back(triangle);
  }
  if (triangles_.empty())
    throw std::invalid_argument("The haptic surface has no triangles; a point set needs them.");
  findNeighbors(surface.points.size());
  fingerprint_ = hash.value();

  const double margin = maxRadius_ + reach;
  low_W_ -= Eigen::Vector3d::Constant(margin);
  high += Eigen::Vector3d::Constant(margin);
  const double largest = std::max({high[0] - low_W_[0], high[1] - low_W_[1], high[2] - low_W_[2]});
  if (largest > largestSurface)
    throw std::invalid_argument("The haptic surface is " + std::to_string(largest * 1e3) +
                                " mm wide; a scala tympani in meters is below 50 mm.");
  cell_ = std::max(usualCell, largest / maxCells);
  for (int axis = 0; axis < 3; ++axis)
    size_[axis] = static_cast<int>((high[axis] - low_W_[axis]) / cell_) + 1;

  const double fromCenter = margin + 0.5 * std::sqrt(3.0) * cell_;
  for (int x = 0; x < size_[0]; ++x)
    for (int y = 0; y < size_[1]; ++y)
      for (int z = 0; z < size_[2]; ++z) {
        first_.push_back(static_cast<int>(inCell_.size()));
        const Eigen::Vector3d center = low_W_ + cell_ * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
          const Triangle& t = triangles_[i];
          // The distance to the plane alone excludes most triangles.
          if (std::fabs(t.inward.dot(center - t.a)) > fromCenter) continue;
          const Eigen::Vector3d weights = anatomy::barycentricWeights(center, t.a, t.b, t.c);
          const Eigen::Vector3d near = weights[0] * t.a + weights[1] * t.b + weights[2] * t.c;
          if ((near - center).norm() <= fromCenter) inCell_.push_back(static_cast<int>(i));
        }
      }
  first_.push_back(static_cast<int>(inCell_.size()));
}

void ProxySurface::findNeighbors(std::size_t corners)
{
  // an edge joins the first two triangles that share it; a third one is ignored
  std::map<std::pair<int, int>, std::pair<std::size_t, std::size_t>> waiting;
  std::vector<std::vector<int>> around(corners);
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<int, 3>& named = triangles_[i].corners;
      around[static_cast<std::size_t>(named[k])].push_back(static_cast<int>(i));
      const int one = named[(k + 1) % 3];
      const int other = named[(k + 2) % 3];
      const std::pair edge{std::min(one, other), std::max(one, other)};
      const auto [found, isFirst] = waiting.try_emplace(edge, i, k);
      if (isFirst) continue;
      const auto [triangle, side] = found->second;
      triangles_[i].across[k] = static_cast<int>(triangle);
      triangles_[triangle].across[side] = static_cast<int>(i);
    }
  for (const std::vector<int>& of : around) {
    firstAround_.push_back(static_cast<int>(around_.size()));
    around_.insert(around_.end(), of.begin(), of.end());
  }
  firstAround_.push_back(static_cast<int>(around_.size()));
}

bool ProxySurface::isInFrontOf(const Eigen::Vector3d& place_W, int triangle) const noexcept
{
  const Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
  return t.inward.dot(place_W - t.a) >= 0.0;
}

/// Whether all triangles that share the point nearest to `place_W` are seen from the front.
bool ProxySurface::sees(const Eigen::Vector3d& place_W, const Triangle& triangle,
                        const Eigen::Vector3d& weights) const noexcept
{
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = weights[static_cast<Eigen::Index>(k)];
    if (weight == 0.0 && triangle.across[k] >= 0 && !isInFrontOf(place_W, triangle.across[k]))
      return false;
    if (weight != 1.0) continue;
    const auto corner = static_cast<std::size_t>(triangle.corners[k]);
    for (int i = firstAround_[corner]; i < firstAround_[corner + 1]; ++i)
      if (!isInFrontOf(place_W, around_[static_cast<std::size_t>(i)])) return false;
  }
  return true;
}

std::size_t ProxySurface::cellOf(const Eigen::Vector3d& place_W) const noexcept
{
  std::size_t index = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double at = (place_W[axis] - low_W_[axis]) / cell_;
    // written so that NaN is outside
    if (!(at >= 0.0 && at < size_[axis])) return nowhere;
    index = index * static_cast<std::size_t>(size_[axis]) + static_cast<std::size_t>(at);
  }
  return index;
}

void ProxySurface::gather(const Eigen::Vector3d& proxy_W, double radius,
                          HalfSpaces& allowed) const noexcept
{
  allowed.clear();
  const std::size_t cell = cellOf(proxy_W);
  if (cell == nowhere) return;
  const double within = radius + reach;
  for (int k = first_[cell]; k < first_[cell + 1]; ++k) {
    const Triangle& t = triangles_[static_cast<std::size_t>(inCell_[static_cast<std::size_t>(k)])];
    const double height = t.inward.dot(proxy_W - t.a);
    if (height < 0.0 || height > within) continue;
    const Eigen::Vector3d weights = anatomy::barycentricWeights(proxy_W, t.a, t.b, t.c);
    const Eigen::Vector3d near = weights[0] * t.a + weights[1] * t.b + weights[2] * t.c;
    const Eigen::Vector3d off = proxy_W - near;
    const double distance = off.norm();
    if (distance > within || !sees(proxy_W, t, weights)) continue;
    const Eigen::Vector3d normal =
        distance > 1e-9 ? Eigen::Vector3d(off / distance) : Eigen::Vector3d(t.inward);
    allowed.add({normal, normal.dot(near) + radius, distance});
  }
}

ProxyHold ProxySurface::follow(const Eigen::Vector3d& proxy_W, const Eigen::Vector3d& goal_W,
                               double radius, HalfSpaces& allowed) const noexcept
{
  constexpr double arrived = 1e-10;  // [m]
  ProxyHold hold{proxy_W, Eigen::Vector3d::Zero(), false};
  for (int move = 0; move < maxMoves; ++move) {
    gather(hold.place_W, radius, allowed);
    Eigen::Vector3d nearest_W = goal_W;
    const Allowed answer = allowed.project(goal_W, nearest_W);
    hold.touches = answer != Allowed::yes;
    // Narrower than the sphere: the proxy stays.
    if (answer == Allowed::nowhere) nearest_W = hold.place_W;
    hold.pressed_W = nearest_W - goal_W;
    const Eigen::Vector3d step = nearest_W - hold.place_W;
    const double length = step.norm();
    if (!(length <= reach)) {
      hold.place_W += (reach / length) * step;
      continue;
    }
    hold.place_W = nearest_W;
    if (length < arrived || !hold.touches) break;
  }
  return hold;
}

}  // namespace perilymph::mechanics
