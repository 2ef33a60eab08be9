// SPDX-License-Identifier: BSD-3-Clause

// Invariance under rotation and mirroring, and independence of history.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

/// Another lumen, rotated about the entry axis (z of W) or mirrored.
class TurnedLumen final : public anatomy::Lumen {
public:
  TurnedLumen(std::shared_ptr<const anatomy::Lumen> inner, Eigen::Matrix3d turn)
      : inner_(std::move(inner)), turn_(std::move(turn))
  {
  }
  anatomy::Entry entry() const noexcept override { return {}; }
  anatomy::LumenTrack startTrack() const noexcept override { return inner_->startTrack(); }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<anatomy::LumenTrack> tracks,
                   std::span<anatomy::WallPoint> walls) const noexcept override
  {
    for (std::size_t i = 0; i < points_W.size(); ++i) {
      const Eigen::Vector3d point = turn_.transpose() * points_W[i];
      inner_->nearestWall({&point, 1}, reach.subspan(i, 1), tracks.subspan(i, 1),
                          walls.subspan(i, 1));
      walls[i].normal_W = turn_ * walls[i].normal_W;
      walls[i].shapeOperator_W = turn_ * walls[i].shapeOperator_W * turn_.transpose();
      walls[i].hessian_W = turn_ * walls[i].hessian_W * turn_.transpose();
    }
  }
  void addTo(Hash&) const noexcept override {}

private:
  std::shared_ptr<const anatomy::Lumen> inner_;
  Eigen::Matrix3d turn_;
};

RodSpec bendSpec()
{
  RodSpec spec;
  spec.friction = 0.06;
  spec.wallStiffness = 2000.0;
  spec.startInside = 1e-3;
  spec.nodes = 61;
  return spec;
}

std::shared_ptr<const anatomy::Lumen> bendingDuct()
{
  return std::make_shared<anatomy::CircularDuct>(0.6e-3, 6e-3, 3e-3);
}

mechanics::Readings insertInto(std::shared_ptr<const anatomy::Lumen> lumen)
{
  TestRod rod(std::move(lumen), bendSpec());
  rod.move({0.0, 0.0, -12e-3}, 4e-3);
  return rod.readings();
}

TEST(InsertionForce, IsTheSameInATurnedScene)
{
  const mechanics::Readings plain = insertInto(bendingDuct());
  ASSERT_GT(plain.axialForce, 0.01);
  for (const double angle : {0.7, 2.1, 4.0}) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const mechanics::Readings turned =
        insertInto(std::make_shared<TurnedLumen>(bendingDuct(), turn));
    EXPECT_NEAR(turned.axialForce, plain.axialForce, test::tolerance(2e-5, "solver"));
    EXPECT_LT((turned.handForce_W - turn * plain.handForce_W).norm(),
              test::tolerance(4e-5, "solver"));
  }
}

TEST(InsertionForce, IsMirroredInAMirroredScene)
{
  const mechanics::Readings plain = insertInto(bendingDuct());
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(0, 0) = -1.0;
  const mechanics::Readings mirrored =
      insertInto(std::make_shared<TurnedLumen>(bendingDuct(), mirror));
  EXPECT_LT((mirrored.handForce_W - mirror * plain.handForce_W).norm(),
            test::tolerance(4e-5, "solver"));
}

TEST(InsertionForce, ReturnsToZeroWhenTheArrayIsOutAgain)
{
  TestRod rod(bendingDuct(), bendSpec());
  rod.move({0.0, 0.0, -12e-3}, 8e-3);
  rod.move({0.0, 0.0, 12e-3}, 8e-3, 0.5);
  EXPECT_LT(rod.readings().handForce_W.norm(), test::tolerance(1e-5, "solver"));
  EXPECT_EQ(rod.readings().contacts, 0);
}

TEST(InsertionForce, GivesNoEnergyToAHandThatReturns)
{
  // A hand that moves and returns has done work, never gained any. Two speeds of motion.
  for (const double pace : {1.0, 6.0}) {
    RodSpec spec = bendSpec();
    TestRod rod(bendingDuct(), spec);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> depth(0.0, 12e-3);
    double work = 0.0;
    double at = 0.0;
    for (int leg = 0; leg < 12; ++leg) {
      const double target = leg == 11 ? 0.0 : depth(random);
      const int ticks = static_cast<int>(std::ceil(std::fabs(target - at) / (pace * 5e-6)));
      for (int i = 0; i < ticks; ++i) {
        const Eigen::Vector3d before = rod.state().base_W;
        const Eigen::Vector3d forceBefore = rod.readings().handForce_W;
        rod.move({0.0, 0.0, -(target - at) / ticks}, 10.0);
        work -= 0.5 * (forceBefore + rod.readings().handForce_W).dot(rod.state().base_W - before);
        ASSERT_TRUE(rod.readings().isFinite);
      }
      at = target;
    }
    EXPECT_GT(work, 0.0) << "pace " << pace;
  }
}

TEST(Advance, GivesTheSameBitsFromTheSameStart)
{
  TestRod one(bendingDuct(), bendSpec());
  TestRod other(bendingDuct(), bendSpec());
  one.move({0.0, 0.0, -10e-3}, 8e-3);
  other.move({0.0, 0.0, -10e-3}, 8e-3);
  EXPECT_EQ(one.state().fingerprint(), other.state().fingerprint());
  // and again after a reset
  const std::uint64_t before = one.state().fingerprint();
  one.state().reset(one.model());
  one.drive().handPosition_W = one.model().startBase_W;
  one.move({0.0, 0.0, -10e-3}, 8e-3);
  EXPECT_EQ(one.state().fingerprint(), before);
}

}  // namespace
}  // namespace perilymph
