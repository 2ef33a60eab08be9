// SPDX-License-Identifier: BSD-3-Clause

// Curled or oval arrays: rotation about their axis, and bending in both directions.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "SideWall.h"
#include "TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

/// The space between two frictionless plates, y = -half and y = half.
class Slot final : public anatomy::Lumen {
public:
  explicit Slot(double half) : half_(half) {}
  anatomy::Entry entry() const noexcept override { return {}; }
  anatomy::LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<anatomy::LumenTrack>,
                   std::span<anatomy::WallPoint> walls) const noexcept override
  {
    for (std::size_t i = 0; i < points_W.size(); ++i) {
      walls[i] = {};
      if (points_W[i].z() > 0.0) continue;
      const double y = points_W[i].y();
      walls[i].distance = half_ - std::fabs(y);
      walls[i].isNear = walls[i].distance <= reach[i];
      walls[i].normal_W = {0.0, y > 0.0 ? -1.0 : 1.0, 0.0};
    }
  }
  void addTo(Hash&) const noexcept override {}

private:
  double half_;
};

constexpr double twisting = 0.5e-6;  // GJ [N.m^2]
constexpr double hook = 4e-3;        // [m] of the tip that is curled

/// A rod whose straight part leads to a hooked tip.
RodSpec hookedSpec()
{
  RodSpec spec;
  spec.startInside = 10e-3;
  spec.restCurvature = 300.0;
  spec.curledFromTip = hook;
  spec.twisting = twisting;
  return spec;
}

/// Rotates the hand about the rod; returns its work.
double roll(TestRod& rod, double from, double to)
{
  constexpr int ticks = 400;
  const Eigen::Vector3d axis = rod.model().startAxis_W;
  double work = 0.0;
  for (int i = 1; i <= ticks; ++i) {
    const double before = rod.readings().handTorque_W.dot(axis);
    const double angle = from + (to - from) * i / ticks;
    rod.drive().handCurl_W = Eigen::AngleAxisd(angle, axis) * rod.model().startCurl_W;
    rod.tick();
    work -= 0.5 * (before + rod.readings().handTorque_W.dot(axis)) * (to - from) / ticks;
  }
  for (int i = 0; i < 300; ++i) rod.tick();
  return work;
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(TwistedRod, ResistsWithItsTwistingStiffnessTimesTwistOverLength)
{
  TestRod rod(std::make_shared<Slot>(0.26e-3), hookedSpec());
  for (int i = 0; i < 600; ++i) rod.tick();
  double last = 0.0;
  for (const double angle : {0.3, 0.8, -0.5}) {
    roll(rod, last, angle);
    last = angle;
    // the hook lies flat between the plates; the straight part before it is twisted
    const std::size_t end = 70;
    const double twist = angleBetween(rod.state().curl_W[0], rod.state().curl_W[end]);
    ASSERT_GT(twist, 0.6 * std::fabs(angle));
    const double expected = twisting * twist / (static_cast<double>(end) * rod.model().spacing);
    const double torque = -rod.readings().handTorque_W.dot(rod.model().startAxis_W);
    EXPECT_NEAR(torque, std::copysign(expected, angle),
                test::tolerance(0.005, "straight") * expected);
  }
}

TEST(TwistedRod, GivesBackTheEnergyOfItsTwist)
{
  TestRod rod(std::make_shared<Slot>(0.26e-3), hookedSpec());
  for (int i = 0; i < 600; ++i) rod.tick();
  const double in = roll(rod, 0.0, 0.8);
  const double torque = rod.readings().handTorque_W.norm();
  EXPECT_NEAR(in, 0.5 * torque * 0.8, test::tolerance(0.08, "the hook gives way first") * in);
  const double back = roll(rod, 0.8, 0.0);
  EXPECT_GE(in + back, 0.0);
  EXPECT_LT(in + back, test::tolerance(0.02, "damping") * in);
}

TEST(TwistedRod, TurnsWithItsHandWhereNothingHoldsIt)
{
  RodSpec spec = hookedSpec();
  spec.startInside = 0.0;
  TestRod rod(std::make_shared<anatomy::FlatWall>(1.0), spec);
  for (int i = 0; i < 1500; ++i) rod.tick();
  const Eigen::Vector3d before = rod.state().position_W.back() - rod.state().base_W;
  roll(rod, 0.0, 1.2);
  for (int i = 0; i < 1500; ++i) rod.tick();
  const Eigen::Vector3d after = rod.state().position_W.back() - rod.state().base_W;
  const Eigen::Vector3d expected = Eigen::AngleAxisd(1.2, rod.model().startAxis_W) * before;
  EXPECT_LT((after - expected).norm(), test::tolerance(0.03e-3, "the perilymph's drag"));
  EXPECT_LT(rod.readings().handTorque_W.norm(), test::tolerance(2e-8, "solver"));
}

TEST(TwistedRod, IsNoneIfItIsStraightAndRound)
{
  RodSpec spec = hookedSpec();
  spec.restCurvature = 0.0;
  TestRod rod(std::make_shared<Slot>(0.26e-3), spec);
  EXPECT_FALSE(rod.model().twists);
  EXPECT_EQ(roll(rod, 0.0, 2.0), 0.0);
}

TEST(TwistedRod, FeelsTheSameInAMirroredScene)
{
  // a hook that is rolled one way, and its mirror image rolled the opposite way
  const auto torqueAfter = [](double angle) {
    TestRod rod(std::make_shared<Slot>(0.26e-3), hookedSpec());
    for (int i = 0; i < 600; ++i) rod.tick();
    roll(rod, 0.0, angle);
    return std::pair(rod.readings().handTorque_W, rod.readings().handForce_W);
  };
  const auto [torque, force] = torqueAfter(0.6);
  const auto [mirroredTorque, mirroredForce] = torqueAfter(-0.6);
  // y changes sign for a force; x and z for a torque
  const Eigen::Vector3d asForce(1.0, -1.0, 1.0);
  EXPECT_LT((mirroredForce - force.cwiseProduct(asForce)).norm(), test::tolerance(4e-6, "solver"));
  EXPECT_LT((mirroredTorque + torque.cwiseProduct(asForce)).norm(),
            test::tolerance(4e-8, "solver"));
}

TEST(OvalRod, BendsByTheStiffnessOfTheDirectionItIsBentIn)
{
  for (const bool bendsWithinCurl : {true, false}) {
    RodSpec spec;
    spec.bending = 1e-4;
    spec.bendingAcross = 4e-4;
    spec.startInside = 10e-3;
    TestRod rod(std::make_shared<test::SideWall>(1e-3), spec);
    const Eigen::Vector3d curl =
        bendsWithinCurl ? Eigen::Vector3d(0, 1, 0) : Eigen::Vector3d(1, 0, 0);
    rod.drive().handCurl_W = curl;
    rod.changeable().startCurl_W = curl;
    rod.state().reset(rod.model());
    rod.move({0.0, -(1e-3 - spec.radius + 0.2e-3), 0.0}, 2e-3, 0.5);
    const double deflection = rod.state().position_W.back().y() - rod.state().base_W.y();
    const double bent = spec.length - 0.5 * rod.model().spacing;
    const double stiffness = bendsWithinCurl ? spec.bending : spec.bendingAcross;
    const double expected = 3.0 * stiffness * deflection / std::pow(bent, 3);
    EXPECT_NEAR(rod.state().normalForce.back(), expected,
                test::tolerance(0.003, "chain of links") * expected)
        << (bendsWithinCurl ? "within" : "across");
  }
}

TEST(OvalRod, TouchesWithTheSideThatIsTurnedToTheWall)
{
  for (const bool isFlatOnIt : {true, false}) {
    RodSpec spec;
    spec.bending = spec.bendingAcross = 1e-3;
    spec.thickness = 0.3e-3;  // within the plane of curl; 0.5 mm across it
    spec.startInside = 10e-3;
    TestRod rod(std::make_shared<test::SideWall>(1e-3), spec);
    const Eigen::Vector3d curl = isFlatOnIt ? Eigen::Vector3d(0, 1, 0) : Eigen::Vector3d(1, 0, 0);
    rod.drive().handCurl_W = curl;
    rod.changeable().startCurl_W = curl;
    rod.state().reset(rod.model());
    const double half = isFlatOnIt ? 0.15e-3 : 0.25e-3;
    rod.move({0.0, -(1e-3 - half - 0.005e-3), 0.0}, 2e-3, 0.05);
    EXPECT_EQ(rod.readings().contacts, 0) << half;
    rod.move({0.0, -0.01e-3, 0.0}, 2e-3, 0.05);
    EXPECT_EQ(rod.readings().contacts, 1) << half;
  }
}

}  // namespace
}  // namespace perilymph
