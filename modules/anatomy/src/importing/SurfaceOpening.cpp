// SPDX-License-Identifier: BSD-3-Clause
#include "importing/SurfaceOpening.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "importing/StraightStretch.h"
#include "mesh/Triangles.h"
#include "numerics/DenseSolvers.h"

namespace perilymph::anatomy {
namespace {

// A lid faces out of the duct within 45 degrees and is at most this deep behind the first section.
constexpr double lidFacing = 0.7;
constexpr double lidDepth = 0.15e-3, lidReach = 2.5e-3;  // [m]

/// The eigenvector of the smallest eigenvalue, and that eigenvalue's fraction of the trace.
std::pair<Eigen::Vector3d, double> minDirection(const Eigen::Matrix3d& scatter)
{
  const Eigen3 parts(scatter);
  int smallest = 0;
  for (int k = 1; k < 3; ++k)
    if (parts.values[k] < parts.values[smallest]) smallest = k;
  const double all = parts.values[0] + parts.values[1] + parts.values[2];
  return {parts.vectors.col(smallest), all > 0.0 ? parts.values[smallest] / all : 1.0};
}

}  // namespace

SurfaceOpening openingOf(const ClosedSurface& closed)
{
  RimFrame rim;
  for (std::size_t i = 0; i < closed.isLid.size(); ++i)
    if (closed.isLid[i])
      rim.corners.insert(closed.surface.triangles[i].begin(), closed.surface.triangles[i].end());

  // the rim's center and its plane
  double around = 0.0;
  for (std::size_t k = 0; k < closed.rim.size(); ++k) {
    const Eigen::Vector3d& a = closed.rim[k];
    const Eigen::Vector3d& b = closed.rim[(k + 1) % closed.rim.size()];
    rim.center += 0.5 * (b - a).norm() * (a + b);
    around += (b - a).norm();
  }
  rim.center /= around;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : closed.rim)
    spread += (p - rim.center) * (p - rim.center).transpose();
  rim.plane = minDirection(spread).first;

  // the direction perpendicular to the wall's normals at the rim
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  double side = 0.0;
  for (std::size_t i = 0; i < closed.isLid.size(); ++i) {
    const auto& t = closed.surface.triangles[i];
    if (closed.isLid[i] ||
        std::none_of(t.begin(), t.end(), [&](int k) { return rim.corners.count(k) > 0; }))
      continue;
    const Eigen::Vector3d across = scaledNormal(closed.surface, t);
    if (across.norm() > 0.0) normals += across * across.transpose() / across.norm();
    for (const int k : t) side += (corner(closed.surface, k) - rim.center).dot(rim.plane);
  }
  std::tie(rim.inward, rim.scatter) = minDirection(normals);
  const double lean = rim.inward.dot(rim.plane);
  if (lean * side < 0.0) rim.inward = -rim.inward;

  SurfaceOpening opening{rim.center, rim.inward, 0.0};
  if (std::fabs(lean) < 0.3)
    opening.inward = side < 0.0 ? Eigen::Vector3d(-rim.plane) : rim.plane;
  else
    opening.leadIn = straightStretch(closed, rim);
  return opening;
}

void openAt(ClosedSurface& closed, const Eigen::Vector3d& first, const Eigen::Vector3d& inward)
{
  for (std::size_t i = 0; i < closed.isLid.size(); ++i) {
    const auto& t = closed.surface.triangles[i];
    const Eigen::Vector3d across = scaledNormal(closed.surface, t);
    const bool isBefore = std::all_of(t.begin(), t.end(), [&](int k) {
      const Eigen::Vector3d e = corner(closed.surface, k) - first;
      return e.dot(inward) < lidDepth && e.norm() < lidReach;
    });
    if (isBefore && -across.dot(inward) > lidFacing * across.norm()) closed.isLid[i] = true;
  }
}

}  // namespace perilymph::anatomy
