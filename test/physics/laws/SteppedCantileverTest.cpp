// SPDX-License-Identifier: BSD-3-Clause

// A cantilever with a step in stiffness at the stylet's end: its tip deflection is that of two
// beams.

#include <gtest/gtest.h>

#include <cmath>

#include "../mechanics/SideWall.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

constexpr double length = 20e-3;    // [m]
constexpr double radius = 0.25e-3;  // [m]
constexpr double carrier = 2e-5;    // EI [N.m^2]
constexpr double stylet = 10e-5;    // EI that it adds [N.m^2]
constexpr double bare = 8e-3;       // [m] in front of the stylet when it is fully in
constexpr int nodes = 41;
constexpr double spacing = length / (nodes - 1);

constexpr double rimGap = 1e-3;  // between the wall and the straight rod's center line [m]

/// @param across  EI of the carrier across the plane of curl [N.m^2].
electrode::ArrayDesign steppedArray(double across)
{
  electrode::ArrayDesign array;
  array.name = "stepped rod";
  array.length = array.insertable = meters(length);
  array.diameter = {{meters(0)}, {meters(2 * radius)}};
  array.bending = {{meters(0)}, {newtonSquareMeters(carrier)}};
  array.bendingAcross = {{meters(0)}, {newtonSquareMeters(across)}};
  array.restCurvature = {{meters(0)}, {Curvature::fromSi(0.0)}};
  array.hasStylet = true;
  array.stylet.fromTip = meters(bare);
  array.stylet.bending = newtonSquareMeters(stylet);
  return array;
}

/// Compliance of the tip [m/N], with the stylet withdrawn by a length [m] and the carrier's EI
/// `across` the plane of curl, in which the wall bends it.
double compliance(double withdrawal, double across)
{
  mechanics::ModelParts parts;
  parts.lumen = std::make_shared<test::SideWall>(rimGap);
  parts.array = steppedArray(across);
  parts.nodes = nodes;
  parts.startInside = meters(0.5 * length);
  parts.friction = {0.0, 0.0, 0.0, millimetersPerSecond(0.1)};
  parts.wall = {newtonsPerMeter(1e5), newtonsPerMeter(1e5), millimeters(0.002)};
  const auto model = mechanics::InsertionModel::build(parts);
  mechanics::InsertionState state(*model);
  mechanics::Drive drive;
  drive.handPosition_W = model->startBase_W;
  drive.handAxis_W = model->startAxis_W;
  drive.handCurl_W = model->startCurl_W;
  drive.styletWithdrawal = withdrawal;
  constexpr double aside = rimGap - radius + 0.2e-3;
  constexpr int steps = 500;
  for (int i = 1; i <= 3 * steps; ++i) {
    const double fraction = std::min(1.0, static_cast<double>(i) / steps);
    drive.handPosition_W.y() = model->startBase_W.y() - fraction * aside;
    mechanics::advance(*model, state, drive);
  }
  return (state.position_W.back().y() - state.base_W.y()) / state.normalForce.back();
}

/// The same for two Euler-Bernoulli beams in series.
double twoBeams(double withdrawal, double across)
{
  const double soft = bare + withdrawal;
  // the tweezers hold the whole first link, so it bends from that link's middle on
  const double bent = length - 0.5 * spacing;
  return std::pow(soft, 3) / (3.0 * across) +
         (std::pow(bent, 3) - std::pow(soft, 3)) / (3.0 * (across + stylet));
}

TEST(SteppedCantilever, YieldsAsItsTwoPiecesWhereverBetweenNodesTheStyletEnds)
{
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double withdrawal = part * spacing;
    const double expected = twoBeams(withdrawal, carrier);
    EXPECT_NEAR(compliance(withdrawal, carrier), expected,
                test::tolerance(0.002, "half a step of the place where it ends") * expected)
        << part;
  }
}

TEST(SteppedCantilever, YieldsAsItsTwoPiecesAlsoBentTheWayItIsStiffer)
{
  constexpr double across = 3.0 * carrier;
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double withdrawal = part * spacing;
    const double expected = twoBeams(withdrawal, across);
    EXPECT_NEAR(compliance(withdrawal, across), expected,
                test::tolerance(0.002, "half a step of the place where it ends") * expected)
        << part;
  }
}

}  // namespace
}  // namespace perilymph
