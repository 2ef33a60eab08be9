// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ArrayInScala.h"

#include <gtest/gtest.h>

#include <limits>

#include "RingScala.h"

namespace perilymph::charts {
namespace {

constexpr double singlePrecision_mm = 1e-5;  // of snapshots
constexpr double slant_mN = 0.2;             // of 30 mN: the curve is inclined inward by 4 degrees
constexpr double rowing_mm = 2e-3;           // sections are sampled every ten degrees

ArrayInScala follow(const haptics::Snapshot& now)
{
  ArrayInScala array(*test::ringScala(), test::plainArray());
  array.follow(now);
  return array;
}

TEST(ArrayInScala, KnowsWhereANodeIsInItsSection)
{
  const ArrayInScala array = follow(test::laidTo(200.0, 0.3, -0.2));
  const NodePlace tip = array.nodes().back();
  EXPECT_NEAR(tip.angle_deg, 200.0, 0.01);
  EXPECT_NEAR(tip.across_mm, 0.3, rowing_mm);
  EXPECT_NEAR(tip.up_mm, -0.2, rowing_mm);
  EXPECT_TRUE(tip.isInside);
  EXPECT_NEAR(array.nodes().front().fromTip_mm, 20.0, singlePrecision_mm);
  EXPECT_NEAR(tip.fromTip_mm, 0.0, singlePrecision_mm);
}

TEST(ArrayInScala, CountsTurns)
{
  EXPECT_NEAR(follow(test::laidTo(700.0, 0.0)).nodes().back().angle_deg, 700.0, 0.01);
}

TEST(ArrayInScala, CountsTheLeadInAsAnglesBelowZero)
{
  const anatomy::Entry entry = test::ringScala()->entry();
  haptics::Snapshot now{};
  now.nodes = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    // 3 mm and 1 mm in front of the plane of the round window; the lead-in is 1 mm long
    const Eigen::Vector3d place_W = entry.origin_W + (i == 0 ? 2e-3 : 0.0) * entry.out_W;
    for (int k = 0; k < 3; ++k) now.node_W[i][std::size_t(k)] = static_cast<float>(place_W[k]);
  }
  const ArrayInScala array = follow(now);
  const double perMillimeter_deg = inDegrees(radians(1.0 / test::ring_mm(0.0)));
  EXPECT_NEAR(array.nodes()[0].angle_deg, -3.0 * perMillimeter_deg, 0.02);
  EXPECT_NEAR(array.nodes()[1].angle_deg, -perMillimeter_deg, 0.02);
  EXPECT_NEAR(array.nodes()[1].across_mm, 0.0, rowing_mm);
  EXPECT_FALSE(array.nodes()[0].isInside);
}

TEST(ArrayInScala, ExcludesFrictionFromTheNormalForce)
{
  haptics::Snapshot now = test::laidTo(200.0, 0.4);
  test::push(now, 50, -30.0);
  // friction, along the array
  const Eigen::Vector3d before(now.node_W[49][0], now.node_W[49][1], now.node_W[49][2]);
  const Eigen::Vector3d after(now.node_W[51][0], now.node_W[51][1], now.node_W[51][2]);
  const Eigen::Vector3d friction = -0.004 * (after - before).normalized();
  for (int k = 0; k < 3; ++k)
    now.wallForce_W[50][std::size_t(k)] += static_cast<float>(friction[k]);
  const NodePlace node = follow(now).nodes()[50];
  EXPECT_NEAR(node.pushAcross_mN, -30.0, slant_mN);
  EXPECT_NEAR(node.normal_mN, 30.0, 0.01);
}

TEST(ArrayInScala, IgnoresANonFiniteSnapshot)
{
  haptics::Snapshot now = test::laidTo(200.0, 0.0);
  now.node_W[30][1] = std::numeric_limits<float>::quiet_NaN();
  const ArrayInScala array = follow(now);
  EXPECT_TRUE(array.nodes().empty());
  EXPECT_FALSE(array.isInside());
}

}  // namespace
}  // namespace perilymph::charts
