// SPDX-License-Identifier: BSD-3-Clause

// Bands of a plan's coarse nodes and steps beside those of the scenario's, with the same draws.

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/Plan.h"

namespace perilymph::test {
namespace {

Result<planning::Plan> planWith(const std::optional<planning::Resolution>& resolution)
{
  const auto patient = anatomy::loadPatient(resource("resources/patients/measured.toml"));
  if (!patient) return patient.error();
  planning::PlanRequest request;
  request.patient = *patient;
  request.arrays = {"flex28", "hifocus-slimj", "slim-straight"};
  request.draws = 48;
  request.stopsEarly = false;
  request.seed = 77;
  request.resolution = resolution;
  return planning::makePlan(request, {}, {});
}

TEST(CoarseDraws, MoveTheBandsByLessThanHalfTheirQuartileRange)
{
  const auto fine = planWith(std::nullopt);
  ASSERT_TRUE(fine) << fine.error().message;
  const auto coarse = planWith(planning::Resolution{});
  ASSERT_TRUE(coarse) << coarse.error().message;
  for (std::size_t i = 0; i < fine->arrays.size(); ++i) {
    const planning::ArrayPlan& a = fine->arrays[i];
    const planning::ArrayPlan& b = coarse->arrays[i];
    const auto compare = [&](const char* name, const planning::Band& from,
                             const planning::Band& to) {
      const double limit = 0.5 * (from.upperQuartile - from.lowerQuartile);
      std::cout << a.array << ", " << name << ": " << from.low << " " << from.median << " "
                << from.high << " fine, " << to.low << " " << to.median << " " << to.high
                << " coarse\n";
      EXPECT_NEAR(to.low, from.low, limit) << a.array << name;
      EXPECT_NEAR(to.median, from.median, limit) << a.array << name;
      EXPECT_NEAR(to.high, from.high, limit) << a.array << name;
    };
    compare("angle", a.angle_deg, b.angle_deg);
    compare("peak", a.peak_mN, b.peak_mN);
  }
  for (std::size_t k = 0; k < fine->insertions.size(); ++k) {
    const auto& one = fine->insertions[k].insertion;
    const auto& other = coarse->insertions[k].insertion;
    if (one.end == other.end && std::abs(inDegrees(one.apical - other.apical)) < 5.0) continue;
    std::cout << "insertion " << k << ": " << haptics::nameOf(one.end) << " at "
              << inDegrees(one.apical) << " deg, " << inMillinewtons(one.peak) << " mN fine, "
              << haptics::nameOf(other.end) << " at " << inDegrees(other.apical) << " deg, "
              << inMillinewtons(other.peak) << " mN coarse\n";
  }
}

}  // namespace
}  // namespace perilymph::test
