// SPDX-License-Identifier: BSD-3-Clause

// Does the chain from bench to ear find a friction that is known? The curves are those of the simulator: a rod
// with clearance, an opening and a three-dimensional scala, none of which the closed form of the fit has.
// So this tests the chain's model, not only its algebra.

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/session/Calibration.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/validation/BenchChain.h"
#include "prediction/VirtualInsertion.h"

namespace perilymph::validation {
namespace {

/// Forces of a Slim Straight every 0.5 mm from 8 to 14 mm, as the posters' machine pushes it, into the
/// smallest cochlea that a patient may have, which is nearest to a pig's.
BenchCurve simulatedCurve(BenchMedium medium, double friction)
{
  BenchCurve curve;
  curve.medium = medium;
  const auto scenario =
      fullInsertionOf("surgery-flex28", "slim-straight", millimeters(1), milliseconds(5),
                      {{"membrane", "rigid"}, {"speed_mm_s", "0.5"}});
  EXPECT_TRUE(scenario) << scenario.error().message;
  if (!scenario) return curve;
  session::InsertionParameters parameters = scenario->parameters();
  parameters.friction.staticCoefficient = parameters.friction.kineticCoefficient = friction;
  parameters.friction.stoppingCoefficient = 0.4 * friction;
  parameters.cochlea.patient.basalTurn =
      anatomy::BasalTurn{millimeters(7.55), millimeters(5.55), {}};
  // half the file's stiffness has the forces of the soap curve (resources/guide/friction.md, the posters)
  parameters.array = session::calibrated(parameters.array, 0.5, 0.0);
  parameters.stopTravel = millimeters(14);  // the tip starts 1 mm inside
  parameters.engine.stopTravel = parameters.stopTravel.si();
  const auto anatomy = session::buildAnatomy(parameters);
  EXPECT_TRUE(anatomy) << anatomy.error().message;
  if (!anatomy) return curve;
  const auto full = analysis::runInsertion(parameters, *anatomy, millimeters(0.5), {});
  EXPECT_EQ(full.end, haptics::InsertionEnd::finished) << full.reason;
  for (const analysis::DepthForce& each : full.profile) {
    const double depth_mm = inMillimeters(each.depth);
    if (depth_mm < 7.99 || depth_mm > 14.01) continue;
    curve.depths.push_back(1e-3 * 0.5 * std::round(2.0 * depth_mm));
    curve.forces.push_back(each.force.si());
  }
  EXPECT_EQ(curve.depths.size(), 13u);
  return curve;
}

/// What the chain says of tissue with a friction.
MediumFriction recovered(double tissue)
{
  BenchSpecimen specimen;
  specimen.name = "simulated";
  std::cout << "simulated with " << tissue << '\n';
  for (const auto& [medium, friction] :
       {std::pair{BenchMedium::soap, 0.0489}, std::pair{BenchMedium::saline, 0.11},
        std::pair{BenchMedium::tissue, tissue}})
    specimen.curves.push_back(simulatedCurve(medium, friction));
  for (const BenchCurve& curve : specimen.curves) {
    std::cout << nameIn(benchMedia, curve.medium) << " [mN]:";
    for (const double force : curve.forces) std::cout << ' ' << 1e3 * force;
    std::cout << '\n';
    if (curve.forces.size() != 13u) return {};
  }
  const BenchResult result = inferFriction({specimen});
  for (const MediumFriction& each : result.media)
    std::cout << nameIn(benchMedia, each.medium) << ": " << each.friction.median << " ("
              << each.friction.low << " to " << each.friction.high << ")\n";
  std::cout << "EI at the tip " << result.tipStiffness << " N m2, growth " << result.growth << '\n';
  return result.media.back();
}

class RecoveredFriction : public testing::TestWithParam<double> {};

TEST_P(RecoveredFriction, IsWithinItsPosterior)
{
  const MediumFriction found = recovered(GetParam());
  EXPECT_LT(found.friction.low, GetParam());
  EXPECT_GT(found.friction.high, GetParam());
}

INSTANTIATE_TEST_SUITE_P(, RecoveredFriction, testing::Values(0.08, 0.165, 0.273));

}  // namespace
}  // namespace perilymph::validation
