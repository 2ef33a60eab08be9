// SPDX-License-Identifier: BSD-3-Clause
#include "friction/FrictionStep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "friction/FrictionKernel.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::mechanics {
namespace {

using test::tolerance;

constexpr double normal = 5e-3;      // [N]
constexpr double stiffness = 200.0;  // [N/m]
constexpr double timeStep = 1e-3;    // [s]
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

/// Rises, then falls, as measured on a tissue simulant (Dohr et al. 2021).
FrictionLaw tissue()
{
  FrictionLaw law{0.24, 0.24, 0.1, millimetersPerSecond(0.1), {}};
  law.bySpeed = {{millimetersPerSecond(0.1), millimetersPerSecond(1.5), millimetersPerSecond(2.0)},
                 {0.24, 0.59, 0.45}};
  return law;
}

/// A node pulled along a wall at a constant speed.
struct PulledNode {
  FrictionStep step;
  double speed = 0.0;

  void pull(double distance)
  {
    step = frictionStep(step.spring_W + distance * Eigen::Vector3d::UnitX(), normal, stiffness,
                        {step.isSliding, speed}, tissue(), timeStep);
    speed = distance / timeStep;
  }
  double friction() const { return -step.force_W.x(); }
};

TEST(FrictionStep, OfANodeThatSlidesSteadilyIsWhatWasMeasuredAtItsSpeed)
{
  for (const double speed : {0.3e-3, 0.66e-3, 1.0e-3, 1.4e-3}) {
    PulledNode node;
    for (int i = 0; i < 200; ++i) node.pull(speed * timeStep);
    EXPECT_NEAR(node.friction(), tissue().sliding(speed) * normal,
                tolerance(1e-9, "the spring has come to rest"))
        << speed;
  }
}

// A node held by a rod between a hand that moves steadily and a wall whose friction rises with speed:
// nothing makes it slip and stop in turns.
TEST(FrictionStep, OfANodePulledByASpringDoesNotAlternate)
{
  constexpr double pull = 30.0;  // [N/m], weaker than the rise of friction with speed
  constexpr double speed = 0.66e-3;
  FrictionStep step;
  double at = 0.0, nodeSpeed = 0.0, last = 0.0;
  for (int i = 1; i <= 2000; ++i) {
    const double hand = speed * timeStep * i;
    const auto from = step;
    // the balance of spring and friction by bisection
    double low = at, high = hand;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      step = frictionStep(from.spring_W + (middle - at) * Eigen::Vector3d::UnitX(), normal,
                          stiffness, {from.isSliding, nodeSpeed}, tissue(), timeStep);
      (pull * (hand - middle) + step.force_W.x() > 0.0 ? low : high) = middle;
    }
    nodeSpeed = (low - at) / timeStep;
    at = low;
    if (i > 1900) {
      EXPECT_NEAR(nodeSpeed, speed, tolerance(0.01, "steady") * speed) << i;
      EXPECT_NEAR(step.force_W.x(), last, tolerance(1e-3, "steady") * normal) << i;
    }
    last = step.force_W.x();
  }
}

TEST(FrictionStep, HasTheDerivativeOfItsForceAsStiffness)
{
  constexpr double d = 1e-9;
  for (const double slip : {0.2e-6, 0.66e-6, 1.2e-6}) {
    const auto at = [&](const Eigen::Vector3d& more) {
      return frictionStep(Eigen::Vector3d(10e-6 + slip, 1e-6, 0.0) + more, normal, stiffness,
                          {true, 0.66e-3}, tissue(), timeStep);
    };
    const FrictionStep here = at(Eigen::Vector3d::Zero());
    ASSERT_TRUE(here.isSliding);
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector3d way = Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d change = (at(d * way).force_W - at(-d * way).force_W) / (2.0 * d);
      EXPECT_LT((change + here.stiffness(up) * way).norm(), tolerance(1e-2, "of up to 200 N/m"));
    }
  }
}

/// The kernel's curve is the law's.
TEST(FrictionStep, SlidesWithTheCurveOfItsLaw)
{
  const FrictionLaw law{0.06, 0.04, 0.02, millimetersPerSecond(0.1), {}};
  for (double speed = 0.0; speed < 3e-3; speed += 0.01e-3)
    ASSERT_EQ(slidingByCurve(law, speed), law.sliding(speed)) << speed;
}

TEST(FrictionStep, NeverPushesANodeOn)
{
  for (double stretch = 0.0; stretch < 60e-6; stretch += 0.1e-6)
    for (double speed = 0.0; speed < 3e-3; speed += 0.1e-3) {
      const FrictionStep step = frictionStep(stretch * Eigen::Vector3d::UnitX(), normal, stiffness,
                                             {true, speed}, tissue(), timeStep);
      ASSERT_LE(step.force_W.x(), 0.0);
      ASSERT_LE(-step.force_W.x(), 0.59 * normal * (1.0 + 1e-12));
      ASSERT_LE(step.spring_W.x(), stretch);
    }
}

}  // namespace
}  // namespace perilymph::mechanics
