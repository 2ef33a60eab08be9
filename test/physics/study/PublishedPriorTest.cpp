// SPDX-License-Identifier: BSD-3-Clause

// The prior-predictive test of the guide is what the shipped draws give, and the program repeats those.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "Table.h"
#include "perilymph/test/Places.h"
#include "perilymph/validation/PriorPredictive.h"

namespace perilymph::validation {
namespace {

std::string travelText(double travel_mm)
{
  std::string text = std::to_string(travel_mm);
  return text.substr(0, text.find('.') + 2);
}

std::vector<RepeatedExperiment> shippedDraws()
{
  std::vector<RepeatedExperiment> draws;
  for (const test::Row& row :
       test::csvRows(test::projectFolder() / "resources/prior-predictive/draws.csv")) {
    RepeatedExperiment one;
    one.number = std::stoull(row.at("draw"));
    one.reason = row.at("reason");
    for (std::size_t i = 0; i < inputCount; ++i) one.inputs[i] = std::stod(row.at(inputNames[i]));
    one.scale = std::stod(row.at("scale"));
    for (std::size_t k = 0; k < comparedTravels_mm.size(); ++k) {
      const std::string travel = travelText(comparedTravels_mm[k]);
      one.force[k] = 1e-3 * std::stod(row.at("force_" + travel + "_mN"));
      if (k > 0) one.slope[k] = std::stod(row.at("slope_" + travel));
    }
    draws.push_back(one);
  }
  return draws;
}

TEST(PublishedPrior, IsPrintedInTheGuideAsItsDrawsGiveIt)
{
  const auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  ASSERT_TRUE(experiment);
  const auto summary = summarize(shippedDraws(), *experiment);
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_EQ(summary->counted, 400);
  const auto page = test::pageRows(test::projectFolder() / "resources/guide/constants.md",
                                   "### What 400 repetitions give");
  std::size_t forces = 0, joint = 0;
  for (const std::vector<std::string>& cells : page) {
    for (const PredictedAnchor& anchor : summary->anchors) {
      if (cells.front() != travelText(anchor.travel_mm) + " mm") continue;
      ++forces;
      ASSERT_GE(cells.size(), 6u);
      EXPECT_NEAR(std::stod(cells[2]), 1e3 * anchor.mean, 0.051);
      EXPECT_NEAR(std::stod(cells[5]), 100.0 * anchor.rankWithError, 0.51);
    }
    for (const JointTest& test : summary->joint) {
      if (cells.front() != "correlated by " + travelText(test.correlation)) continue;
      ++joint;
      EXPECT_NEAR(std::stod(cells[1]), test.distance, 0.051);
      EXPECT_NEAR(std::stod(cells[2]), test.pValue, 0.0051);
      EXPECT_NEAR(std::stod(cells[3]), test.counted, 0.0051);
    }
  }
  EXPECT_EQ(forces, 5u);
  EXPECT_EQ(joint, 2u);
}

TEST(PublishedPrior, IsRepeatedByTheProgram)
{
  const auto request = shippedPrior();
  ASSERT_TRUE(request) << request.error().message;
  const std::vector<RepeatedExperiment> draws = shippedDraws();
  ASSERT_GE(draws.size(), 400u);
  for (const std::uint64_t number : {1u, 2u}) {
    const auto now = repeatExperiment(*request, number);
    ASSERT_TRUE(now) << now.error().message;
    const RepeatedExperiment& published = draws.at(number - 1);
    ASSERT_EQ(published.number, number);
    EXPECT_EQ(now->reason, published.reason);
    EXPECT_EQ(now->inputs, published.inputs);
    EXPECT_NEAR(now->scale, published.scale, 0.002);
    for (std::size_t k = 0; k < now->force.size(); ++k)
      EXPECT_NEAR(now->force[k], published.force[k], 0.3e-3) << comparedTravels_mm[k];
  }
}

}  // namespace
}  // namespace perilymph::validation
