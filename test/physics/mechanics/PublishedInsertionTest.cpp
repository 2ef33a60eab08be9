// SPDX-License-Identifier: BSD-3-Clause

// The published experiment's array in the published anatomy: properties independent of the
// calibration.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

/// One insertion as published: 2 mm/s, 16.5 mm, the tip 2 mm inside.
struct Curve {
  double tick = 0.0;          // [m] of travel between samples
  std::vector<double> force;  // axial [N], one per tick
  std::vector<double> wall;   // total wall force [N]
  double worstResidual = 0.0;
};

/// The opening of the experiment: a drilled hole, 1 mm wide and long.
mechanics::Opening drilled()
{
  mechanics::Opening opening = mechanics::cochleostomy();
  opening.passage = millimeters(1);
  return opening;
}

struct Variation {
  double scale = 1.0;      // of the whole cochlea
  double stiffness = 1.0;  // of the array
  double travel = 16.5e-3;
  std::optional<mechanics::Opening> opening = drilled();
  bool hasRibs = true;
  bool isStraight = false;  // without its curl
};

Curve insertAsPublished(const Variation& variation)
{
  anatomy::Patient patient;
  patient.scalaTympaniLength = variation.scale * patient.scalaTympaniLength;
  patient.roundWindowWidth = variation.scale * patient.roundWindowWidth;
  patient.roundWindowHeight = variation.scale * patient.roundWindowHeight;
  mechanics::ModelParts parts;
  parts.lumen = anatomy::buildPublished(patient, millimeters(1));
  parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
  for (auto& bending : parts.array.bending.value) bending = variation.stiffness * bending;
  parts.array.stylet.bending = variation.stiffness * parts.array.stylet.bending;
  parts.opening = variation.opening;
  if (variation.isStraight)
    for (auto& curvature : parts.array.restCurvature.value) curvature = Curvature{};
  if (!variation.hasRibs) parts.array.ribsFromTip.clear();
  const auto model = mechanics::InsertionModel::build(parts);
  mechanics::InsertionState state(*model);
  mechanics::Drive drive;
  drive.handAxis_W = model->startAxis_W;
  drive.handCurl_W = model->startCurl_W;

  Curve curve;
  curve.tick = 2e-3 * model->timeStep;
  const long ticks = std::lround(variation.travel / curve.tick);
  for (long k = 1; k <= ticks; ++k) {
    drive.handPosition_W =
        model->startBase_W + (static_cast<double>(k) * curve.tick) * model->startAxis_W;
    mechanics::advance(*model, state, drive);
    curve.force.push_back(state.readings.axialForce);
    curve.wall.push_back(state.readings.wallForceTotal);
    curve.worstResidual = std::max(curve.worstResidual, state.readings.residual);
  }
  return curve;
}

/// The first maximum above 10 mN that is followed by a fall of at least 3 %.
struct Peak {
  double travel = 0.0;
  double force = 0.0;
  double dipTravel = 0.0;
  double dipForce = 0.0;
};

Peak basalTurnPeak(const Curve& curve)
{
  Peak peak;
  for (std::size_t i = 0; i < curve.force.size(); ++i) {
    if (curve.force[i] > peak.force) {
      peak.force = peak.dipForce = curve.force[i];
      peak.travel = curve.tick * static_cast<double>(i + 1);
    } else if (curve.force[i] < peak.dipForce) {
      peak.dipForce = curve.force[i];
      peak.dipTravel = curve.tick * static_cast<double>(i + 1);
    }
    // the dip is over when the force has risen from it by as much as counts as a fall
    if (peak.force > 10e-3 && peak.dipForce < 0.97 * peak.force &&
        curve.force[i] > peak.dipForce + 0.03 * peak.force)
      break;
  }
  return peak;
}

TEST(PublishedInsertion, HasNoForceBeforeTheFirstContact)
{
  const Curve curve = insertAsPublished({.isStraight = true});
  std::size_t touching = 0;
  while (touching < curve.wall.size() && curve.wall[touching] == 0.0) ++touching;
  // the straight array meets the outer wall on its way to the basal turn: 3 to 6 mm by the geometry
  // of the spiral (a chord from the round window)
  const double firstTouch = curve.tick * static_cast<double>(touching);
  EXPECT_GT(firstTouch, 3e-3);
  EXPECT_LT(firstTouch, 6e-3);
  // the first tick sets the array in motion: 25 mm of silicone, at most 0.8 mm thick, are at most
  // 14.5 mg, and 14.5 mg x 2 mm/s / 1 ms = 29 uN
  EXPECT_LT(std::fabs(curve.force[0]), 29e-6);
  // before it nothing but the perilymph's drag, 0.05 N.s/m2 x 25 mm x 2 mm/s = 2.5 uN, and what the
  // solver leaves: 2 uN on a node, of which a few add up at the hand
  for (std::size_t i = 1; i < touching; ++i) ASSERT_LT(std::fabs(curve.force[i]), 10e-6) << i;
}

TEST(PublishedInsertion, PeaksAtTheBasalTurnThenDips)
{
  const Peak peak = basalTurnPeak(insertAsPublished({}));
  // the paper: peak between 9 and 12 mm (raw), 10.6 mm (spline), dip at 11.8 mm
  EXPECT_GT(peak.travel, 8e-3);
  EXPECT_LT(peak.travel, 13e-3);
  EXPECT_GT(peak.dipTravel, peak.travel);
  EXPECT_LT(peak.dipForce, 0.95 * peak.force);
}

TEST(PublishedInsertion, SettlesInEveryTick)
{
  EXPECT_LT(insertAsPublished({}).worstResidual, 1e-5);
}

TEST(PublishedInsertion, PeaksLaterAndLowerInALargerCochlea)
{
  // The peak comes when the tip has gone around the basal turn, so it moves with the size of the
  // cochlea; the force to bend a rod into a circle falls with the square of its radius.
  const Peak small = basalTurnPeak(insertAsPublished({.scale = 0.9}));
  const Peak middle = basalTurnPeak(insertAsPublished({}));
  const Peak large = basalTurnPeak(insertAsPublished({.scale = 1.1}));
  EXPECT_LT(small.travel, middle.travel);
  EXPECT_LT(middle.travel, large.travel);
  EXPECT_GT(small.force, middle.force);
  EXPECT_GT(middle.force, large.force);
}

TEST(PublishedInsertion, GrowsWithTheArraysStiffness)
{
  // Below the wall's own stiffness, forces are linear in EI (mechanics README); a soft wall takes
  // some.
  const Peak soft = basalTurnPeak(insertAsPublished({.stiffness = 0.5}));
  const Peak stiff = basalTurnPeak(insertAsPublished({.stiffness = 1.0}));
  EXPECT_GT(stiff.force, 1.6 * soft.force);
  EXPECT_LT(stiff.force, 2.05 * soft.force);
}

TEST(PublishedInsertion, RisesWhereTheFirstRibEntersThePassageAndFallsWhereItLeaves)
{
  const auto run = [](bool hasRibs) {
    return insertAsPublished({.travel = 16.6e-3, .hasRibs = hasRibs});
  };
  const Curve with = run(true);
  const Curve without = run(false);
  // The rib, 17.0 mm from the tip, reaches 0.275 mm to both sides, with the radius of the edge, and
  // is wider than the passage up to 0.14 mm; the tip started 2 mm inside, the passage is 1 mm long.
  constexpr double meets = 14.725e-3, isInside = 15.16e-3, leaves = 15.84e-3, isOut = 16.275e-3;
  double rise = 0.0, inside = 1.0, fall = 1.0;
  for (std::size_t i = 0; i < with.force.size(); ++i) {
    const double travel = with.tick * static_cast<double>(i + 1);
    const double difference = with.force[i] - without.force[i];
    if (travel < meets - 0.02e-3) {
      ASSERT_EQ(difference, 0.0) << travel;
    } else if (travel < isInside) {
      rise = std::max(rise, difference);
    } else if (travel < leaves) {
      inside = std::min(inside, difference);
    } else if (travel < isOut) {
      fall = std::min(fall, difference);
    } else if (travel > isOut + 0.1e-3) {
      ASSERT_NEAR(difference, 0.0, 2e-3) << travel;
    }
  }
  // 2 pi E m^2 at the crest, and friction on the half that is inside (guide, constants)
  EXPECT_NEAR(rise, 0.081, test::tolerance(0.08, "bent array") * 0.081);
  // nothing pulls it in between, it rubs: 0.0395 times 4 pi E times the integral of m
  EXPECT_NEAR(inside, 0.0134, test::tolerance(0.002, "bent array"));
  EXPECT_LT(fall, -0.05);
  EXPECT_LT(with.worstResidual, 1e-5);
}

}  // namespace
}  // namespace perilymph
