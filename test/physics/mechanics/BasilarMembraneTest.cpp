// SPDX-License-Identifier: BSD-3-Clause

// The compliant part of the roof: its position, its stiffness, and conservation of energy.

#include <gtest/gtest.h>

#include <cmath>

#include "TestRod.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using mechanics::MembraneFraction;
using mechanics::MembranePlace;
using test::RodSpec;
using test::TestRod;

std::shared_ptr<const anatomy::ScalaTympani> meanScala()
{
  static const auto scala = *anatomy::buildMean(millimeters(1));
  return scala;
}

anatomy::LumenTrack trackAt(double angle)
{
  return {false, angle, {std::cos(angle), std::sin(angle)}};
}

/// The fraction at a position given by angle, and across the membrane from its inner edge (0) to
/// its outer one (1).
MembraneFraction fractionAt(double angle, double across, double radius)
{
  static const MembranePlace place(*meanScala());
  return place.fractionAt(meanScala()->membrane_W(angle, across), radius, trackAt(angle),
                          -Eigen::Vector3d::UnitZ());
}

TEST(BasilarMembrane, IsAllThereIsAboveAThinArrayInItsMiddleAndNothingBesideIt)
{
  for (const double angle_deg : {30.0, 90.0, 200.0, 450.0, 650.0}) {
    const double angle = degrees(angle_deg).si();
    EXPECT_NEAR(fractionAt(angle, 0.5, 0.05e-3).fraction, 1.0, 1e-9) << angle_deg;
    EXPECT_EQ(fractionAt(angle, -0.5, 0.05e-3).fraction, 0.0) << angle_deg;
    EXPECT_EQ(fractionAt(angle, 1.5, 0.05e-3).fraction, 0.0) << angle_deg;
  }
}

TEST(BasilarMembrane, LeavesAWideArrayPartlyOnTheBoneBesideIt)
{
  const double angle = degrees(45).si();
  const auto width = (meanScala()->membrane_W(angle, 1) - meanScala()->membrane_W(angle, 0)).norm();
  const double fraction = fractionAt(angle, 0.5, 1.5 * width).fraction;
  EXPECT_GT(fraction, 0.5);
  EXPECT_LT(fraction, 0.95);
}

TEST(BasilarMembrane, IsNotInTheFloor)
{
  const double angle = degrees(200).si();
  const MembranePlace place(*meanScala());
  EXPECT_EQ(place
                .fractionAt(meanScala()->membrane_W(angle, 0.5), 0.1e-3, trackAt(angle),
                            Eigen::Vector3d::UnitZ())
                .fraction,
            0.0);
}

TEST(BasilarMembrane, HasAFractionWhoseGradientIsItsDerivative)
{
  const MembranePlace place(*meanScala());
  const auto at = [&](const Eigen::Vector3d& point) {
    const double angle = std::atan2(point.y(), point.x());
    return place.fractionAt(point, 0.3e-3, trackAt(angle), -Eigen::Vector3d::UnitZ());
  };
  for (const double angle_deg : {3.0, 40.0, 100.0, 170.0})
    for (const double across : {-0.1, 0.1, 0.4, 0.7, 1.1}) {
      const Eigen::Vector3d point = meanScala()->membrane_W(degrees(angle_deg).si(), across);
      const MembraneFraction fraction = at(point);
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d step = 1e-7 * Eigen::Vector3d::Unit(k);
        const double slope = (at(point + step).fraction - at(point - step).fraction) / 2e-7;
        EXPECT_NEAR(fraction.gradient_W[k], slope, 2.0) << angle_deg << " deg, " << across;
      }
    }
}

/// A thin stylus that reaches under the membrane of the basal turn.
struct Stylus {
  Stylus() : rod(meanScala(), spec())
  {
    rod.move({0.0, 0.0, 0.6e-3}, 1e-3);
    rod.move(-0.8e-3 * rod.model().entry.outward_W, 1e-3);
  }
  static RodSpec spec()
  {
    RodSpec spec;
    spec.length = 8e-3;
    spec.radius = 0.1e-3;
    spec.bending = 1e-5;
    spec.startInside = 4e-3;
    spec.nodes = 33;
    spec.wallStiffness = 441.0;
    spec.membrane = mechanics::MembraneLaw{newtonsPerMeter(9), millimeters(0.05)};
    return spec;
  }
  TestRod rod;
};

TEST(BasilarMembrane, YieldsByItsLaw)
{
  Stylus stylus;
  const mechanics::InsertionModel& model = stylus.rod.model();
  int seen = 0;
  for (int step = 0; step < 100; ++step) {
    stylus.rod.move(0.005e-3 * model.entry.outward_W, 1e-3);
    const mechanics::InsertionState& state = stylus.rod.state();
    for (std::size_t i = 0; i < state.position_W.size(); ++i) {
      if (!(state.membraneForce[i] > 2e-5)) continue;
      anatomy::LumenTrack track = state.track[i];
      anatomy::WallPoint wall;
      const double reach = 1e-3;
      meanScala()->nearestWall({&state.position_W[i], 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
      const double p = model.radius[i] - wall.distance;
      const double fraction =
          model.membrane->fractionAt(state.position_W[i], model.radius[i], track, wall.normal_W)
              .fraction;
      // the length of wall represented by a node, as for bone
      const double k = 9.0 * model.wallStiffness[i] / 441.0;
      const double expected = fraction * k * (p - 1e-6 + p * p * p / (0.05e-3 * 0.05e-3));
      EXPECT_NEAR(state.membraneForce[i], expected, 1e-3 * expected);
      ++seen;
    }
  }
  EXPECT_GT(seen, 10);
}

TEST(BasilarMembrane, GivesBackWhatItTookFromAHandThatSweepsAcrossIt)
{
  Stylus stylus;
  const Eigen::Vector3d outward_W = stylus.rod.model().entry.outward_W;
  double work = 0.0, maximum = 0.0, membrane = 0.0;
  for (const double direction : {1.0, -1.0})
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector3d before = stylus.rod.state().base_W;
      const Eigen::Vector3d force = stylus.rod.readings().handForce_W;
      stylus.rod.move(direction * 1e-6 * outward_W, 1e-3);
      work -=
          0.5 * (force + stylus.rod.readings().handForce_W).dot(stylus.rod.state().base_W - before);
      maximum = std::max(maximum, std::fabs(work));
      membrane = std::max(membrane, stylus.rod.readings().membraneForce);
      ASSERT_LT((stylus.rod.readings().handForce_W - force).norm(), 0.5e-3) << "a kink at " << i;
    }
  EXPECT_GT(membrane, 4e-5);
  EXPECT_NEAR(work, 0.0, test::tolerance(0.02, "damping, drag") * maximum);
}

}  // namespace
}  // namespace perilymph
