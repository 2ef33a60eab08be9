// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/broadcast/BroadcastFrame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace perilymph::broadcast {
namespace {

/// A straight array of 11 nodes, 1 mm apart along x, its tip at 10 mm.
haptics::Snapshot straight()
{
  haptics::Snapshot now{};
  now.nodes = 11;
  for (std::uint32_t i = 0; i < now.nodes; ++i)
    now.node_W[i] = {1e-3f * static_cast<float>(i), 2e-3f, 0.0f};
  now.baseAxis_W = {1.0, 0.0, 0.0};
  now.output.proxy_W = {0.0, 2e-3, 0.0};
  now.output.tip_W = {10e-3, 2e-3, 0.0};
  now.output.force_W = {-0.1, 0.02, 0.03};
  now.output.axialForce = 0.1;
  return now;
}

electrode::ArrayDesign withContacts(std::vector<double> places_mm)
{
  electrode::ArrayDesign array;
  for (const double place : places_mm) array.contactsFromTip.push_back(millimeters(place));
  return array;
}

constexpr double singlePrecision = 1e-8;  // of a node's place: 1e-2 m in 24 bits [m]

TEST(BroadcastFrame, PutsContactsAtTheirDistanceFromTheTip)
{
  const auto frame = broadcastFrame(straight(), withContacts({0.0, 0.5, 2.25, 9.75}));
  ASSERT_EQ(frame.contacts, 4u);
  const double expected[] = {10e-3, 9.5e-3, 7.75e-3, 0.25e-3};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(frame.contact_W[i][0], expected[i], singlePrecision);
    EXPECT_NEAR(frame.contact_W[i][1], 2e-3, singlePrecision);
  }
}

TEST(BroadcastFrame, KeepsContactsBeyondTheBaseAtTheBase)
{
  const auto frame = broadcastFrame(straight(), withContacts({9.5, 12.0}));
  EXPECT_NEAR(frame.contact_W[1][0], 0.0, singlePrecision);
}

TEST(BroadcastFrame, PointsZAlongTheArrayInARightHandedFrame)
{
  const auto frame = broadcastFrame(straight(), withContacts({}));
  for (const Pose& pose : {frame.tip, frame.tweezers}) {
    EXPECT_NEAR(pose.axis_W[2][0], 1.0, 1e-6);
    const auto& [x, y, z] = pose.axis_W;
    const double volume = x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
                          x[2] * (y[0] * z[1] - y[1] * z[0]);
    EXPECT_NEAR(volume, 1.0, 1e-12);
  }
  EXPECT_NEAR(frame.tip.place_W[0], 10e-3, singlePrecision);
  EXPECT_EQ(frame.tweezers.place_W[1], 2e-3);
  EXPECT_EQ(frame.force_W[0], -0.1);
}

TEST(BroadcastFrame, HasTheSectionOfTheArrayAtEachNode)
{
  electrode::ArrayDesign array;
  array.length = millimeters(10);
  array.diameter = {{millimeters(0), millimeters(10)}, {millimeters(0.4), millimeters(0.8)}};
  array.thickness = {{millimeters(0)}, {millimeters(0.3)}};
  const auto frame = broadcastFrame(straight(), array);
  ASSERT_EQ(frame.nodes, 11u);
  EXPECT_NEAR(frame.halfWidth[0][1], 0.4e-3, singlePrecision);  // the base
  EXPECT_NEAR(frame.halfWidth[5][1], 0.3e-3, singlePrecision);
  EXPECT_NEAR(frame.halfWidth[5][0], 0.15e-3, singlePrecision);
  EXPECT_EQ(frame.node_W[3], straight().node_W[3]);
}

TEST(BroadcastFrame, HasNoShapeIfANodeIsNotFinite)
{
  haptics::Snapshot now = straight();
  now.node_W[4][1] = NAN;
  const auto frame = broadcastFrame(now, withContacts({1.0}));
  EXPECT_EQ(frame.nodes, 0u);
  EXPECT_EQ(frame.contacts, 0u);
}

TEST(BroadcastFrame, HasNoContactsWithoutAnArray)
{
  haptics::Snapshot now = straight();
  now.nodes = 1;
  EXPECT_EQ(broadcastFrame(now, withContacts({1.0})).contacts, 0u);
}

}  // namespace
}  // namespace perilymph::broadcast
