// SPDX-License-Identifier: BSD-3-Clause

// Arrays with wires that yield, in the hand and out of the cochlea again.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "../mechanics/TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

/// Wires with 0.8 of the stiffness of an array, which yield fully at a moment [N.m].
electrode::Wires wiresThatYieldAt(double moment, double bending)
{
  electrode::Wires wires;
  wires.number = {{millimeters(0)}, {1.0}};
  wires.diameter = millimeters(0.1);
  const double d = wires.diameter.si();
  wires.modulus = Modulus::fromSi(0.8 * bending * 64.0 / (pi * d * d * d * d));
  wires.yieldStress.value = Modulus::fromSi(moment * 6.0 / (d * d * d));
  return wires;
}

RodSpec arrayWith(double moment)
{
  RodSpec spec;
  spec.startInside = 1e-3;
  spec.friction = 0.1;
  if (moment > 0.0) spec.wires = wiresThatYieldAt(moment, spec.bending);
  return spec;
}

/// The largest bend between two edges of the array.
double largestBend(TestRod& rod)
{
  const auto& x = rod.state().position_W;
  double largest = 0.0;
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const Eigen::Vector3d p = (x[i] - x[i - 1]).normalized(), t = (x[i + 1] - x[i]).normalized();
    largest = std::max(largest, p.cross(t).norm());
  }
  return largest;
}

TEST(YieldingArray, LeavesACurvedDuctBent)
{
  const auto duct = std::make_shared<anatomy::CircularDuct>(0.45e-3, 6e-3, 2e-3);
  TestRod elastic(duct, arrayWith(0.0)), yielding(duct, arrayWith(60e-6));
  for (TestRod* each : {&elastic, &yielding}) {
    each->move({0.0, 0.0, -11e-3}, 10e-3);
    EXPECT_GT(largestBend(*each), 0.02);
  }
  EXPECT_LT(yielding.readings().axialForce, 0.95 * elastic.readings().axialForce);
  EXPECT_GT(yielding.readings().plasticWork, 1e-6);
  EXPECT_EQ(elastic.readings().plasticWork, 0.0);
  for (TestRod* each : {&elastic, &yielding}) each->move({0.0, 0.0, 13e-3}, 20e-3, 0.5);
  EXPECT_LT(largestBend(elastic), 1e-3);
  EXPECT_GT(largestBend(yielding), 5e-3);
}

TEST(YieldingArray, MovedInAndOutGivesTheHandNoEnergy)
{
  TestRod rod(std::make_shared<anatomy::CircularDuct>(0.45e-3, 6e-3, 2e-3), arrayWith(60e-6));
  double work = 0.0, minimum = 0.0;
  for (int loop = 0; loop < 2; ++loop)
    for (const double distance : {9e-3, -9e-3}) {
      constexpr int pieces = 300;
      for (int i = 0; i < pieces; ++i) {
        const double before = rod.readings().axialForce;
        rod.move({0.0, 0.0, -distance / pieces}, 10e-3);
        work += 0.5 * (before + rod.readings().axialForce) * distance / pieces;
        minimum = std::min(minimum, work);
      }
    }
  EXPECT_GE(minimum, -1e-6);
  EXPECT_GT(work, rod.readings().plasticWork - 1e-6);
}

TEST(YieldingArray, ThatIsBentTurnsWithTheHand)
{
  RodSpec spec = arrayWith(1e-3);
  spec.length = 10e-3;
  spec.nodes = 41;
  TestRod rod(std::make_shared<anatomy::StraightTube>(50e-3), spec);
  for (double& bend : rod.state().plasticBend[0].along) bend = 0.03;
  for (double& bend : rod.state().plasticBend[0].across) bend = 0.01;
  rod.move({0.0, 0.0, 0.0}, 1.0, 0.3);
  const auto tip = [&rod] {
    const mechanics::Drive& drive = rod.drive();
    Eigen::Matrix3d frame;
    frame << drive.handAxis_W, drive.handCurl_W, drive.handAxis_W.cross(drive.handCurl_W);
    return Eigen::Vector3d(frame.transpose() *
                           (rod.state().position_W.back() - rod.state().base_W));
  };
  const Eigen::Vector3d before = tip();
  // the set of the wires in the array, (B / (A + B)) q, at each of its 39 joints: a chain of links
  const double angle = 2.0 * std::atan(0.5 * 0.8 * std::hypot(0.03, 0.01));
  const double chain =
      0.25e-3 * std::sin(19.5 * angle) * std::sin(20.0 * angle) / std::sin(0.5 * angle);
  EXPECT_NEAR(before.tail<2>().norm(), chain, 5e-6);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2e-3, Eigen::Vector3d(0.3, 0.4, -0.9).normalized()).toRotationMatrix();
  for (int i = 0; i < 1200; ++i) {
    rod.drive().handAxis_W = (turn * rod.drive().handAxis_W).normalized();
    Eigen::Vector3d curl = turn * rod.drive().handCurl_W;
    curl -= curl.dot(rod.drive().handAxis_W) * rod.drive().handAxis_W;
    rod.drive().handCurl_W = curl.normalized();
    rod.tick();
  }
  rod.move({0.0, 0.0, 0.0}, 1.0, 0.5);
  EXPECT_LT((tip() - before).norm(), 2e-6);
}

}  // namespace
}  // namespace perilymph
