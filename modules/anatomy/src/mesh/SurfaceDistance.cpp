// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/SurfaceDistance.h"
#include "mesh/Triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace perilymph::anatomy {
namespace {

constexpr int maxTrianglesPerBox = 4;
constexpr int deepest = 64;  // boxes halve: a tree of 2^31 triangles has 31 levels

double squaredDistance(const Eigen::Vector3d& point, const Eigen::Vector3d& low,
                       const Eigen::Vector3d& high) noexcept
{
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double out = std::max({low[axis] - point[axis], point[axis] - high[axis], 0.0});
    sum += out * out;
  }
  return sum;
}

}  // namespace

Eigen::Vector3d barycentricWeights(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                   const Eigen::Vector3d& b, const Eigen::Vector3d& c) noexcept
{
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 > d3 ? d1 / (d1 - d3) : 0.0;
    return {1.0 - v, v, 0.0};
  }
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 > d6 ? d2 / (d2 - d6) : 0.0;
    return {1.0 - w, 0.0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    const double along = (d4 - d3) + (d5 - d6);
    const double w = along > 0.0 ? (d4 - d3) / along : 0.0;
    return {0.0, 1.0 - w, w};
  }
  const double whole = va + vb + vc;
  return {va / whole, vb / whole, vc / whole};
}

SurfaceDistance::SurfaceDistance(const Surface& surface)
{
  for (const auto& t : surface.triangles)
    triangles_.push_back({corner(surface, t[0]), corner(surface, t[1]), corner(surface, t[2])});
  names_.resize(triangles_.size());
  std::iota(names_.begin(), names_.end(), 0);
  if (triangles_.empty()) return;
  divide(0, static_cast<int>(triangles_.size()));

  std::vector<Corners> sorted;
  for (const int name : names_) sorted.push_back(triangles_[static_cast<std::size_t>(name)]);
  triangles_ = std::move(sorted);
}

int SurfaceDistance::divide(int first, int count)
{
  const auto self = static_cast<int>(boxes_.size());
  Box box;
  box.low.setConstant(1e9);
  box.high.setConstant(-1e9);
  box.first = first;
  box.count = count;
  for (int i = first; i < first + count; ++i) {
    const Corners& t = triangles_[static_cast<std::size_t>(names_[static_cast<std::size_t>(i)])];
    box.low = box.low.cwiseMin(t.a).cwiseMin(t.b).cwiseMin(t.c);
    box.high = box.high.cwiseMax(t.a).cwiseMax(t.b).cwiseMax(t.c);
  }
  boxes_.push_back(box);
  if (count <= maxTrianglesPerBox) return self;

  // halve at the median along the longest side
  int axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const auto place = [&](int name) {
    const Corners& t = triangles_[static_cast<std::size_t>(name)];
    return t.a[axis] + t.b[axis] + t.c[axis];
  };
  const int half = count / 2;
  std::nth_element(names_.begin() + first, names_.begin() + first + half,
                   names_.begin() + first + count, [&](int one, int other) {
                     const double here = place(one), there = place(other);
                     return here != there ? here < there : one < other;
                   });
  divide(first, half);
  const int second = divide(first + half, count - half);
  boxes_[static_cast<std::size_t>(self)].second = second;
  boxes_[static_cast<std::size_t>(self)].count = 0;
  return self;
}

SurfaceFoot SurfaceDistance::nearest(const Eigen::Vector3d& point, double reach) const noexcept
{
  SurfaceFoot foot;
  if (boxes_.empty() || !point.allFinite()) return foot;
  double nearest = reach * reach;

  std::array<int, deepest> waiting{};
  std::size_t left = 1;
  while (left > 0) {
    const int self = waiting[--left];
    const Box& box = boxes_[static_cast<std::size_t>(self)];
    if (squaredDistance(point, box.low, box.high) > nearest) continue;
    if (box.count == 0) {
      // search the nearer box first
      const Box& one = boxes_[static_cast<std::size_t>(self) + 1];
      const Box& other = boxes_[static_cast<std::size_t>(box.second)];
      const bool oneIsNearer = squaredDistance(point, one.low, one.high) <=
                               squaredDistance(point, other.low, other.high);
      waiting[left++] = oneIsNearer ? box.second : self + 1;
      waiting[left++] = oneIsNearer ? self + 1 : box.second;
      continue;
    }
    for (int i = box.first; i < box.first + box.count; ++i) {
      const Corners& t = triangles_[static_cast<std::size_t>(i)];
      const Eigen::Vector3d weights = barycentricWeights(point, t.a, t.b, t.c);
      const Eigen::Vector3d place = weights[0] * t.a + weights[1] * t.b + weights[2] * t.c;
      const double squared = (place - point).squaredNorm();
      if (squared > nearest) continue;
      nearest = squared;
      foot = {names_[static_cast<std::size_t>(i)], 0.0, place, weights};
    }
  }
  foot.distance = std::sqrt(nearest);
  return foot;
}

}  // namespace perilymph::anatomy
