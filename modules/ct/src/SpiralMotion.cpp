// SPDX-License-Identifier: BSD-3-Clause
#include "SpiralMotion.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace perilymph::ct {
namespace {

using Seven = Eigen::Matrix<double, 7, 1>;
using Seven2 = Eigen::Matrix<double, 7, 7>;

constexpr double freedomOfStudent = 4.0;
constexpr double pointSpread = 0.02;   // of points, in units of the cochlea's size
constexpr double normalSpread = 0.15;  // of normals

Seven constraint(const Eigen::Vector3d& p, const Eigen::Vector3d& n)
{
  Seven phi;
  phi << p.cross(n), n, p.dot(n);
  return phi;
}

/// J J^T for the errors of the point and of the normal.
Seven2 uncertainty(const Eigen::Vector3d& p, const Eigen::Vector3d& n)
{
  Eigen::Matrix<double, 7, 6> derivative = Eigen::Matrix<double, 7, 6>::Zero();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(k);
    derivative.col(k) << unit.cross(n), Eigen::Vector3d::Zero(), n[k];
    derivative.col(3 + k) << p.cross(unit), unit, p[k];
  }
  derivative.leftCols<3>() *= pointSpread;
  derivative.rightCols<3>() *= normalSpread;
  return derivative * derivative.transpose();
}

}  // namespace

std::optional<SpiralAxis> fitSpiralMotion(const std::vector<SurfacePoint>& points, int rounds)
{
  if (points.size() < 50) return std::nullopt;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const SurfacePoint& each : points) middle += each.point;
  middle /= static_cast<double>(points.size());
  double size = 0.0;
  for (const SurfacePoint& each : points) size += (each.point - middle).squaredNorm();
  size = std::sqrt(size / static_cast<double>(points.size()));

  std::vector<double> weights(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) weights[i] = points[i].weight;
  Seven motion = Seven::Zero();
  for (int round = 0; round < rounds; ++round) {
    Seven2 left = Seven2::Zero(), right = Seven2::Identity() * 1e-9;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d p = (points[i].point - middle) / size;
      const Seven phi = constraint(p, points[i].normal);
      left += weights[i] * phi * phi.transpose();
      right += weights[i] * uncertainty(p, points[i].normal);
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Seven2> solver(left, right);
    if (solver.info() != Eigen::Success) return std::nullopt;
    motion = solver.eigenvectors().col(0);

    double sum = 0.0, weightSum = 0.0;
    std::vector<double> squares(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d p = (points[i].point - middle) / size;
      const double off = constraint(p, points[i].normal).dot(motion);
      const double spread = motion.dot(uncertainty(p, points[i].normal) * motion);
      squares[i] = off * off / std::max(1e-12, spread);
      sum += weights[i] * squares[i];
      weightSum += weights[i];
    }
    const double scale = std::max(1e-9, sum / weightSum);
    for (std::size_t i = 0; i < points.size(); ++i)
      weights[i] =
          points[i].weight * (freedomOfStudent + 1.0) / (freedomOfStudent + squares[i] / scale);
  }
  const Eigen::Vector3d r = motion.head<3>(), c = motion.segment<3>(3);
  if (r.norm() < 1e-3 * motion.norm()) return std::nullopt;
  Eigen::Matrix3d still = motion[6] * Eigen::Matrix3d::Identity();
  still +=
      (Eigen::Matrix3d() << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0).finished();
  // Without growth the velocity has no zero: take the point of the axis nearest to the center.
  Eigen::Vector3d center = r.cross(c) / r.squaredNorm();
  if (std::fabs(motion[6]) > 1e-3 * r.norm()) center = -still.fullPivLu().solve(c);
  return SpiralAxis{r.normalized(), middle + size * center};
}

}  // namespace perilymph::ct
