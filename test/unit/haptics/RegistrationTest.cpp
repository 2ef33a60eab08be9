// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/Registration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::haptics {
namespace {

constexpr double rounding = 1e-12;

/// An opening whose frame E is rotated: E.x = W.y, E.y = W.z, E.z = W.x.
anatomy::Entry turnedEntry()
{
  anatomy::Entry entry;
  entry.origin_W = {0.01, 0.02, 0.03};
  entry.outward_W = Eigen::Vector3d::UnitY();
  entry.vertical_W = Eigen::Vector3d::UnitZ();
  entry.out_W = Eigen::Vector3d::UnitX();
  return entry;
}

BasePose start()
{
  return {{0.05, 0.0, 0.0}, -Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitY()};
}

HandState handAt(const Eigen::Vector3d& position_D)
{
  HandState hand;
  hand.position_D = position_D;
  return hand;
}

TEST(Registration, TakesAPushAwayFromTheUserIntoTheCochlea)
{
  Registration registration(turnedEntry(), -turnedEntry().out_W, 1.0);
  registration.anchor(handAt({0.1, 0.2, 0.3}), start());
  const BasePose pose = registration.pose(handAt({0.1, 0.2, 0.3 - 2e-3}));
  const Eigen::Vector3d moved_W = pose.position_W - start().position_W;
  EXPECT_NEAR((moved_W - Eigen::Vector3d(-2e-3, 0.0, 0.0)).norm(), 0.0, rounding);
}

TEST(Registration, PushesTheArrayAlongItsApproach)
{
  const Eigen::Vector3d approach_W = Eigen::Vector3d(-3.0, 1.0, 2.0).normalized();
  Registration registration(turnedEntry(), approach_W, 1.0);
  registration.anchor(handAt({0, 0, 0}), start());
  const Eigen::Vector3d pushed_W = registration.pose(handAt({0, 0, -2e-3})).position_W;
  EXPECT_NEAR((pushed_W - start().position_W - 2e-3 * approach_W).norm(), 0.0, rounding);
  EXPECT_NEAR((registration.inward_W() - approach_W).norm(), 0.0, rounding);
  // D stays right-handed and orthonormal: no force is lost
  const Eigen::Vector3d force_W(0.3, -0.4, 1.2);
  EXPECT_NEAR(registration.toDevice(force_W).norm(), 1.3, rounding);
  const Eigen::Vector3d x_W = registration.toCochlea(Eigen::Vector3d::UnitX());
  const Eigen::Vector3d y_W = registration.toCochlea(Eigen::Vector3d::UnitY());
  EXPECT_NEAR((x_W.cross(y_W) + approach_W).norm(), 0.0, rounding);
}

TEST(Registration, StaysWhereTheBaseIsWhenTheHandTakesHold)
{
  Registration registration(turnedEntry(), -turnedEntry().out_W, 1.0);
  const HandState hand = handAt({-3.0, 4.0, 0.3});
  registration.anchor(hand, start());
  EXPECT_NEAR((registration.pose(hand).position_W - start().position_W).norm(), 0.0, rounding);
  EXPECT_NEAR((registration.pose(hand).axis_W - start().axis_W).norm(), 0.0, rounding);
}

TEST(Registration, ScalesTheMotion)
{
  Registration registration(turnedEntry(), -turnedEntry().out_W, 0.25);
  registration.anchor(handAt({0, 0, 0}), start());
  const BasePose pose = registration.pose(handAt({4e-3, 8e-3, 0}));
  const Eigen::Vector3d moved_W = pose.position_W - start().position_W;
  EXPECT_NEAR((moved_W - Eigen::Vector3d(0.0, 1e-3, 2e-3)).norm(), 0.0, rounding);
}

TEST(Registration, TurnsAxisAndCurlByTheRotationSinceTheAnchor)
{
  Registration registration(turnedEntry(), -turnedEntry().out_W, 1.0);
  HandState hand = handAt({0, 0, 0});
  const Eigen::AngleAxisd held(0.4, Eigen::Vector3d::UnitY());
  hand.rotation_D = Eigen::Quaterniond(held);
  registration.anchor(hand, start());

  // roll by 90 degrees about D.z, which is E.z = W.x
  const Eigen::AngleAxisd roll(degrees(90).si(), Eigen::Vector3d::UnitZ());
  hand.rotation_D = Eigen::Quaterniond(roll) * hand.rotation_D;
  const BasePose pose = registration.pose(hand);
  EXPECT_NEAR((pose.axis_W - start().axis_W).norm(), 0.0, rounding);
  // E.x -> E.y under that roll, so -W.y -> -W.z
  EXPECT_NEAR((pose.curl_W - Eigen::Vector3d(0.0, 0.0, -1.0)).norm(), 0.0, rounding);
}

TEST(Registration, GivesForcesBackInTheFrameTheyCameFrom)
{
  const Registration registration(turnedEntry(), -turnedEntry().out_W, 1.0);
  const Eigen::Vector3d force_W(0.1, 0.2, 0.3);
  // out of the cochlea: toward the user
  EXPECT_EQ(registration.toDevice(force_W), Eigen::Vector3d(0.2, 0.3, 0.1));
  EXPECT_EQ(registration.toCochlea(registration.toDevice(force_W)), force_W);
}

TEST(Registration, KeepsUnitVectorsUnitOverManyClutches)
{
  Registration registration(turnedEntry(), -turnedEntry().out_W, 1.0);
  HandState hand = handAt({0, 0, 0});
  BasePose pose = start();
  for (int i = 0; i < 20'000; ++i) {
    registration.anchor(hand, pose);
    hand.rotation_D = hand.rotation_D *
                      Eigen::Quaterniond(Eigen::AngleAxisd(0.01, Eigen::Vector3d(0.6, 0.0, 0.8)));
    hand.rotation_D.normalize();
    pose = registration.pose(hand);
  }
  EXPECT_NEAR(pose.axis_W.norm(), 1.0, rounding);
  EXPECT_NEAR(pose.curl_W.norm(), 1.0, rounding);
  EXPECT_NEAR(pose.axis_W.dot(pose.curl_W), 0.0, rounding);
}

}  // namespace
}  // namespace perilymph::haptics
