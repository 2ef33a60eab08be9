// SPDX-License-Identifier: BSD-3-Clause

// The axis of spiral surfaces with a motion known in closed form.

#include "SpiralMotion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

/// Points of a tube that is invariant under a spiral motion about z: rotation, translation and
/// scaling.
std::vector<SurfacePoint> conicalTube(const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift)
{
  const auto place = [](double t, double f) {
    const double size = std::exp(-0.12 * t);
    const double r = 4.0 + std::cos(f);
    return Eigen::Vector3d(size * r * std::cos(t), size * r * std::sin(t), size * std::sin(f));
  };
  std::vector<SurfacePoint> points;
  for (double t = 0.0; t < 9.0; t += 0.1)
    for (double f = 0.0; f < 6.2; f += 0.3) {
      const Eigen::Vector3d along = place(t + 1e-5, f) - place(t - 1e-5, f);
      const Eigen::Vector3d around = place(t, f + 1e-5) - place(t, f - 1e-5);
      points.push_back({turn * place(t, f) + shift, turn * along.cross(around).normalized(), 1.0});
    }
  return points;
}

TEST(SpiralMotion, FindsTheAxisOfAConicalTube)
{
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const Eigen::Vector3d shift(12.0, -30.0, 7.0);
  const auto axis = fitSpiralMotion(conicalTube(turn, shift));
  ASSERT_TRUE(axis);
  EXPECT_GT(std::fabs(axis->direction.dot(turn.col(2))), std::cos(degrees(0.1).si()));
  const Eigen::Vector3d off = axis->center - shift;
  EXPECT_LT((off - off.dot(turn.col(2)) * turn.col(2)).norm(), 0.02);
}

TEST(SpiralMotion, IsNotMisledByPointsOfSomethingElse)
{
  std::vector<SurfacePoint> points =
      conicalTube(Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  const std::size_t count = points.size() / 8;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i);
    points.push_back({Eigen::Vector3d(6.0 + std::sin(x), std::cos(2.0 * x), std::sin(3.0 * x)),
                      Eigen::Vector3d(std::cos(x), std::sin(x), 0.5).normalized(), 1.0});
  }
  const auto axis = fitSpiralMotion(points);
  ASSERT_TRUE(axis);
  EXPECT_GT(std::fabs(axis->direction.z()), std::cos(degrees(1.0).si()));
}

TEST(SpiralMotion, NeedsPoints) { EXPECT_FALSE(fitSpiralMotion({})); }

}  // namespace
}  // namespace perilymph::ct
