// SPDX-License-Identifier: BSD-3-Clause
#include "points/PointFriction.h"

#include <gtest/gtest.h>

namespace perilymph::mechanics {
namespace {

// Published: starting 0.0605, dynamic 0.0395, stopping 0.0185, 200 N/m (Todd and Naghdy, II.C).
constexpr double normal = 0.1;       // [N]
constexpr double stiffness = 200.0;  // [N/m]

/// Friction for a spring force given as a fraction of the normal force.
PointFriction atRatio(double ratio, bool wasSliding)
{
  return pointFriction({ratio * normal / stiffness, 0.0, 0.0}, normal, stiffness, wasSliding, {});
}

TEST(PointFriction, HoldsARestingPointUpToTheStartingCoefficient)
{
  const PointFriction below = atRatio(0.0604, false);
  EXPECT_FALSE(below.isSliding);
  EXPECT_NEAR(below.force_W.x(), -0.0604 * normal, 1e-15);
  EXPECT_TRUE(atRatio(0.0606, false).isSliding);
}

TEST(PointFriction, SlidesWithTheDynamicCoefficientHoweverFarItIsPulled)
{
  for (const double ratio : {0.0606, 0.1, 10.0}) {
    const PointFriction slid = atRatio(ratio, false);
    EXPECT_NEAR(slid.force_W.x(), -0.0395 * normal, 1e-12);
    EXPECT_NEAR(slid.spring_W.x(), 0.0395 * normal / stiffness, 1e-12);
  }
}

TEST(PointFriction, GoesOnSlidingUntilBelowTheStoppingCoefficient)
{
  EXPECT_TRUE(atRatio(0.0396, true).isSliding);
  EXPECT_TRUE(atRatio(0.0186, true).isSliding);
  EXPECT_FALSE(atRatio(0.0184, true).isSliding);
}

TEST(PointFriction, NeverHoldsWithoutANormalForce)
{
  const PointFriction free = pointFriction({1e-3, 0.0, 0.0}, 0.0, stiffness, false, {});
  EXPECT_EQ(free.force_W.norm(), 0.0);
  EXPECT_EQ(free.spring_W.norm(), 0.0);
}

}  // namespace
}  // namespace perilymph::mechanics
