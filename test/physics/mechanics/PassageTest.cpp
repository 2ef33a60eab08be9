// SPDX-License-Identifier: BSD-3-Clause

// The passage of a drilled opening: it squeezes ribs, holds the array at both edges and rubs.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

std::shared_ptr<const anatomy::Lumen> wideTube()
{
  return std::make_shared<anatomy::StraightTube>(5e-3);
}

/// A stiff rod in the middle of a passage that is narrower than its rib, which starts 1 mm outside.
struct Ribbed {
  static constexpr double radius = 0.25e-3, hole = 0.28e-3, height = 0.06e-3;
  static constexpr double reach = 0.3e-3;  // of the rib, with the radius of the edge
  static constexpr double modulus = 2e6, length = 1e-3;

  static RodSpec spec()
  {
    RodSpec spec;
    spec.bending = 1e-4;
    spec.startInside = 8e-3;
    spec.wallStiffness = 1e4;
    spec.opening = mechanics::cochleostomy(meters(2.0 * hole));
    spec.opening->passage = meters(length);
    spec.ribHeight = height;
    spec.ribLength = 2.0 * (reach - spec.opening->edgeRadius.si());
    spec.ribsFromTip = {millimeters(9)};
    return spec;
  }

  /// Interference of the rib with the hole at x from its middle.
  static double interference(double x)
  {
    const double q = x / reach;
    return q * q < 1.0 ? std::max(radius + height * std::pow(1.0 - q * q, 2) - hole, 0.0) : 0.0;
  }

  /// Integral of a power of the interference over the rib, in steps of 0.1 um.
  static double integral(int power)
  {
    double sum = 0.0;
    for (double x = -reach; x < reach; x += 1e-7) sum += std::pow(interference(x), power) * 1e-7;
    return sum;
  }

  /// Energy of the squeezed rib. A solid cylinder of radius R and Poisson's ratio 1/2, free to
  /// expand along its axis, resists a radial displacement m by the pressure E m / ((1 - 1/2) R);
  /// half of it times m on the circumference 2 pi R is 2 pi E m^2 per length.
  static double energy() { return 2.0 * pi * modulus * integral(2); }
};

/// Work of the hand and largest force over a travel in, or out (direction -1).
struct Push {
  double work = 0.0;
  double maximum = 0.0;
};

Push push(TestRod& rod, double travel, double direction = 1.0, double speed = 2e-3)
{
  const double step = speed * rod.model().timeStep;
  Push push;
  for (long i = std::lround(travel / step); i > 0; --i) {
    const double before = rod.readings().axialForce;
    rod.move({0.0, 0.0, -direction * step}, speed);
    push.work += 0.5 * (before + rod.readings().axialForce) * direction * step;
    push.maximum = std::max(push.maximum, rod.readings().axialForce);
  }
  return push;
}

/// The perilymph's drag, 0.05 N.s/m2 on the rod's length, over a travel at 2 mm/s.
double dragWork(double travel) { return 0.05 * RodSpec().length * 2e-3 * travel; }

TEST(Passage, TakesTheEnergyOfTheSqueezedRibWhenItEnters)
{
  TestRod rod(wideTube(), Ribbed::spec());
  const double work = push(rod, 1.5e-3).work - dragWork(1.5e-3);
  EXPECT_NEAR(work, Ribbed::energy(), test::tolerance(0.01, "steps of 2 um") * Ribbed::energy());
}

TEST(Passage, ResistsByTheEnergyPerLengthOfTheSectionAtItsEdge)
{
  TestRod rod(wideTube(), Ribbed::spec());
  const double crest = Ribbed::interference(0.0);
  const double expected = 2.0 * pi * Ribbed::modulus * crest * crest;
  EXPECT_NEAR(push(rod, 1.5e-3).maximum, expected, test::tolerance(0.01, "steps") * expected);
}

TEST(Passage, NeitherHoldsNorPullsARibThatIsInside)
{
  TestRod rod(wideTube(), Ribbed::spec());
  push(rod, 1.4e-3);
  for (int i = 0; i < 100; ++i) {
    rod.move({0.0, 0.0, -0.002e-3}, 2e-3);
    ASSERT_LT(std::fabs(rod.readings().axialForce), 1e-5);  // drag, inertia
    ASSERT_GT(rod.readings().rimForce, 0.01);
  }
}

TEST(Passage, LetsARibSlideEvenlyAlongOneSideOfItsWall)
{
  // pressed to one side by 1e4 N/m under a sample point: at every place the same
  RodSpec spec = Ribbed::spec();
  spec.ribHeight = 0.02e-3;  // passes without being squeezed
  TestRod rod(wideTube(), spec);
  rod.move({0.1e-3, 0.0, 0.0}, 1e-3, 0.2);
  push(rod, 1.4e-3);
  double low = 1.0, high = -1.0;
  for (int i = 0; i < 100; ++i) {
    rod.move({0.0, 0.0, -0.002e-3}, 2e-3);
    low = std::min(low, rod.readings().axialForce);
    high = std::max(high, rod.readings().axialForce);
  }
  const double push = rod.readings().rimForce;
  ASSERT_GT(push, 0.01);
  EXPECT_LT(high - low, test::tolerance(0.02, "rings, growing depth") * push);
}

TEST(Passage, GivesTheEnergyBackWhereTheRibLeavesAtItsFarEnd)
{
  TestRod rod(wideTube(), Ribbed::spec());
  push(rod, 1.5e-3);
  const double work = push(rod, 1e-3).work - dragWork(1e-3);
  EXPECT_NEAR(work, -Ribbed::energy(), test::tolerance(0.01, "steps of 2 um") * Ribbed::energy());
  EXPECT_EQ(rod.readings().rimForce, 0.0);
}

TEST(Passage, GivesBackWhatARibDoesNotLose)
{
  for (const double loss : {0.3, 1.0})
    for (const double timeStep : {1e-3, 5e-3}) {
      RodSpec spec = Ribbed::spec();
      spec.opening->ribExitLoss = loss;
      spec.timeStep = timeStep;
      TestRod rod(wideTube(), spec);
      push(rod, 1.5e-3);
      const double work = push(rod, 1e-3).work - dragWork(1e-3);
      EXPECT_NEAR(work, -(1.0 - loss) * Ribbed::energy(),
                  test::tolerance(0.02, "steps of 2 to 10 um") * Ribbed::energy())
          << loss << ", " << timeStep << " s";
    }
}

TEST(Passage, LosesTheEnergyOfARibOnTheWayBackToo)
{
  // in and out again: what is lost at the inner edge, twice
  RodSpec spec = Ribbed::spec();
  spec.opening->ribExitLoss = 0.5;
  TestRod rod(wideTube(), spec);
  const double loop =
      push(rod, 2.5e-3).work + push(rod, 2.5e-3, -1.0).work - 2.0 * dragWork(2.5e-3);
  EXPECT_NEAR(loop, 2.0 * 0.5 * Ribbed::energy(),
              test::tolerance(0.02, "steps of 2 um") * Ribbed::energy());
}

TEST(Passage, FindsItsBalanceWhereARibTurnsBackWhileItLeaves)
{
  RodSpec spec = Ribbed::spec();
  spec.opening->ribExitLoss = 1.0;
  TestRod rod(wideTube(), spec);
  push(rod, 1.95e-3);
  for (int turn = 0; turn < 20; ++turn) {
    push(rod, 10e-6, turn % 2 == 0 ? -1.0 : 1.0);
    EXPECT_LT(rod.readings().residual, 2e-6) << turn;  // the solver's tolerance
    rod.tick();
    EXPECT_LT(rod.readings().residual, 2e-6) << turn << ", at rest";
  }
}

TEST(Passage, HasNoNetEnergyOverALoopInAndOut)
{
  for (const double turn : {1.3e-3, 2.0e-3, 2.5e-3}) {
    TestRod rod(wideTube(), Ribbed::spec());
    const double loop = push(rod, turn).work + push(rod, turn, -1.0).work - 2.0 * dragWork(turn);
    EXPECT_LT(std::fabs(loop), test::tolerance(0.01, "damping of the rod") * Ribbed::energy())
        << turn;
  }
}

TEST(Passage, RubsOnTheSqueezedRibWithCoulombsForce)
{
  RodSpec spec = Ribbed::spec();
  spec.friction = 0.05;
  TestRod rod(wideTube(), spec);
  push(rod, 1.5e-3);
  // 2 pi R times the pressure 2 E m / R, along the rib
  const double pressed = 4.0 * pi * Ribbed::modulus * Ribbed::integral(1);
  EXPECT_NEAR(rod.readings().rimForce, pressed, test::tolerance(0.001, "table") * pressed);
  const double expected = 0.05 * pressed;
  EXPECT_NEAR(rod.readings().axialForce, expected, test::tolerance(0.01, "drag") * expected);

  spec.opening->passageFriction = 0.3;
  TestRod rough(wideTube(), spec);
  push(rough, 1.5e-3);
  EXPECT_NEAR(rough.readings().axialForce, 0.3 * pressed, test::tolerance(0.01, "drag") * expected);
}

TEST(Passage, GivesTheSameWorkAndPeakWithEveryStepAndNumberOfNodes)
{
  const auto insertion = [](double timeStep, int nodes) {
    RodSpec spec = Ribbed::spec();
    spec.friction = 0.05;
    spec.timeStep = timeStep;
    spec.nodes = nodes;
    TestRod rod(wideTube(), spec);
    return push(rod, 1.5e-3);
  };
  const Push fine = insertion(0.5e-3, 400);
  for (const double timeStep : {0.5e-3, 1e-3, 2e-3})
    for (const int nodes : {100, 200, 400}) {
      const Push coarse = insertion(timeStep, nodes);
      EXPECT_NEAR(coarse.work, fine.work, test::tolerance(0.01, "convergence") * fine.work)
          << timeStep << " s, " << nodes;
      EXPECT_NEAR(coarse.maximum, fine.maximum, test::tolerance(0.01, "convergence") * fine.maximum)
          << timeStep << " s, " << nodes;
    }
}

/// A cantilever from the middle of the first link, in the tweezers, whose base is `offset` beside
/// the axis of the passage: forces at its outer and its inner edge, on opposite sides.
struct Inclined {
  static constexpr double offset = 0.3e-3, hole = 0.27e-3, radius = 0.25e-3;

  static RodSpec spec()
  {
    RodSpec spec;
    spec.bending = 1e-5;
    spec.wallStiffness = 1e4;
    spec.startInside = 10e-3;
    spec.opening = mechanics::cochleostomy(meters(2.0 * hole));
    spec.opening->passage = millimeters(2);
    return spec;
  }

  /// Deflection of the cantilever at x by a unit force at a [m/N].
  static double deflection(double x, double a)
  {
    const double near = std::min(x, a), far = std::max(x, a);
    return near * near * (3.0 * far - near) / (6.0 * spec().bending);
  }

  /// Sum of both forces at a depth.
  static double force(double depth)
  {
    const double outer = spec().length - depth - 0.5 * spec().length / (spec().nodes - 1);
    const double inner = outer + spec().opening->passage.si();
    const double yielding = 1.0 / spec().wallStiffness;
    const double slack = hole - radius + 1e-6;  // half the onset
    // offset - F1 d11 + F2 d12 = slack + F1 / k,   F1 d21 - F2 d22 - offset = slack + F2 / k
    const double a = deflection(outer, outer) + yielding, b = -deflection(outer, inner);
    const double c = deflection(inner, outer), d = -deflection(inner, inner) - yielding;
    const double p = offset - slack, q = offset + slack;
    const double determinant = a * d - b * c;
    return (p * d - b * q) / determinant + (a * q - c * p) / determinant;
  }
};

TEST(Passage, HoldsAnInclinedArrayAtBothEdges)
{
  TestRod rod(wideTube(), Inclined::spec());
  rod.move({Inclined::offset, 0.0, 0.0}, 1e-3, 0.2);
  for (int i = 1; i <= 60; ++i) {
    rod.move({0.0, 0.0, -0.02e-3}, 2e-3);
    const double expected = Inclined::force(10e-3 + i * 0.02e-3);
    ASSERT_NEAR(rod.readings().rimForce, expected,
                test::tolerance(0.02, "chain of links") * expected)
        << i;
  }
}

TEST(Passage, HasNoNetEnergyWhileATipAsideEntersAndLeavesIt)
{
  RodSpec spec = Inclined::spec();
  spec.startInside = 0.1e-3;
  spec.bending = 1e-4;
  TestRod rod(wideTube(), spec);
  rod.move({0.15e-3, 0.0, 0.0}, 1e-3, 0.2);
  const Push in = push(rod, 5e-3);
  const Push out = push(rod, 5e-3, -1.0);
  ASSERT_GT(in.work, 10.0 * dragWork(5e-3));
  EXPECT_LT(std::fabs(in.work + out.work - 2.0 * dragWork(5e-3)),
            test::tolerance(0.01, "damping of the rod") * in.work);
}

}  // namespace
}  // namespace perilymph
