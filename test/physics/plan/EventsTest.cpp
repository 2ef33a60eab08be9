// SPDX-License-Identifier: BSD-3-Clause

// Each end that a plan counts occurs where it should: full depth in slippery cochleae, resistance in
// tissue, buckling of arrays with soft bodies, a folded tip where a curved array leaves its sheath too
// early, a ruptured partition where a curved array is pushed up.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/copyChanged.h"

namespace perilymph::test {
namespace {

using Changes = std::vector<std::pair<std::string, std::string>>;

const Changes inTissue = {{"friction = \"estimate-from-pig-tissue\"", "friction = \"tissue\""}};

class PlannedEnds : public testing::Test {
protected:
  /// The arrays of a plan by the surgery's scenario with changed text.
  std::vector<planning::ArrayPlan> planWith(const Changes& changes, std::size_t draws,
                                            const std::vector<std::string>& arrays)
  {
    planning::PlanRequest request;
    const auto patient = anatomy::loadPatient(resource("resources/patients/measured.toml"));
    EXPECT_TRUE(patient);
    if (patient) request.patient = *patient;
    request.scenario = copyChanged(resource("resources/scenarios/surgery-flex28.toml"),
                                   folder_ / "scenario.toml", changes);
    request.arrays = arrays;
    request.draws = draws;
    request.seed = 5;
    request.resolution = planning::Resolution{40, milliseconds(10)};
    const auto plan = planning::makePlan(request, {}, {});
    EXPECT_TRUE(plan) << (plan ? "" : plan.error().message);
    return plan ? plan->arrays : std::vector<planning::ArrayPlan>(arrays.size());
  }
  TemporaryFolder folder_;
};

TEST_F(PlannedEnds, AreFullDepthInSoap)
{
  const auto arrays = planWith(
      {{"friction = \"estimate-from-pig-tissue\"", "friction = \"soap-10\""}}, 1, {"flex20"});
  EXPECT_EQ(arrays[0].full.value, 1.0);
}

TEST_F(PlannedEnds, AreResistanceAndBucklingInTissue)
{
  const auto arrays = planWith(inTissue, 4, {"medel-standard", "flexsoft"});
  EXPECT_GT(arrays[0].resisted.value, 0.0);
  EXPECT_GT(arrays[0].buckled.value + arrays[1].buckled.value, 0.0);
}

TEST_F(PlannedEnds, AreAFoldedTipWhereACurvedArrayLeavesItsSheathTooEarly)
{
  // the sheath is held 3 mm past the opening, before the basal turn begins
  const auto early =
      copyChanged(resource("plugins/electrodes/cochlear/slim-modiolar.toml"),
                  folder_ / "early.toml", {{"hold_depth_mm = 5.0", "hold_depth_mm = 3.0"}});
  Changes changes = inTissue;
  changes.emplace_back("technique = \"standard\"", "technique = \"aos\"");
  const auto arrays = planWith(changes, 4, {early, "slim-modiolar"});
  EXPECT_GT(arrays[0].foldedTip.value, 0.0);
  EXPECT_EQ(arrays[1].foldedTip.value, 0.0);
}

TEST_F(PlannedEnds, AreARupturedPartitionWhereACurvedArrayIsPushedUpAgainstIt)
{
  const auto arrays =
      planWith({{"friction = \"estimate-from-pig-tissue\"", "friction = \"soap-10\""},
                {"membrane = \"soft\"", "membrane = \"rigid\""},
                {"approach_tilt_deg = 0.0", "approach_tilt_deg = 30.0"}},
               3, {"contour"});
  EXPECT_GT(arrays[0].ruptured.value, 0.0);
  EXPECT_GE(arrays[0].ruptured.value, arrays[0].translocated.value);
}

}  // namespace
}  // namespace perilymph::test
