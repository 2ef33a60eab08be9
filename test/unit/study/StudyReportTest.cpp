// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::study {
namespace {

using testing::HasSubstr;

/// Results with known effects: angle = 400 + 30 (A - 9) + 50 for the long array - 20 for tissue - 8
/// for both, plus a part of the cochlea that no factor explains.
std::vector<StudyResult> knownResults(std::size_t cochleae)
{
  std::vector<StudyResult> results;
  for (std::size_t c = 0; c < cochleae; ++c)
    for (const bool isLong : {false, true})
      for (const bool isTissue : {false, true}) {
        StudyResult result;
        result.number = results.size();
        result.cochlea = "virtual " + std::to_string(c + 1);
        result.settings = {{"array", isLong ? "long" : "short"},
                           {"friction", isTissue ? "tissue" : "soap"},
                           {"speed_mm_s", std::to_string(0.3 + 0.01 * static_cast<double>(c))}};
        result.a_mm = 8.0 + 2.0 * static_cast<double>(c) / static_cast<double>(cochleae - 1);
        result.b_mm = 6.8;
        const double own = c % 2 == 0 ? 3.0 : -3.0;
        const double angle = 400.0 + 30.0 * (result.a_mm - 9.0) + (isLong ? 50.0 : 0.0) -
                             (isTissue ? 20.0 : 0.0) - (isLong && isTissue ? 8.0 : 0.0) + own;
        result.insertion.end = analysis::InsertionEnd::finished;
        result.insertion.apical = degrees(angle);
        results.push_back(result);
      }
  return results;
}

Estimate effectNamed(const std::vector<Effect>& effects, const std::string& name)
{
  for (const Effect& each : effects)
    if (each.name == name) return each.size;
  ADD_FAILURE() << "There is no effect " << name;
  return {};
}

TEST(StudyReport, FindsTheEffectsThatArePresent)
{
  const StudyEvaluation study(knownResults(20));
  EXPECT_EQ(study.ranges(), std::vector<std::string>{"speed_mm_s"});
  const auto effects = study.mainEffects(Outcome::angle);
  ASSERT_EQ(effects.size(), 4u);
  // Half of the difference between the levels, with half of what they do together.
  EXPECT_NEAR(effectNamed(effects, "array = long").value, 25.0 - 2.0, 1e-9);
  EXPECT_NEAR(effectNamed(effects, "array = short").value, -23.0, 1e-9);
  EXPECT_NEAR(effectNamed(effects, "friction = tissue").value, -10.0 - 2.0, 1e-9);
  const auto together = study.interactions(Outcome::angle);
  ASSERT_EQ(together.size(), 4u);
  EXPECT_NEAR(effectNamed(together, "array = long, friction = tissue").value, -2.0, 1e-9);
  // Nothing varies between cochleae but the mean, so these are known exactly.
  EXPECT_NEAR(together.front().size.high - together.front().size.low, 0.0, 1e-9);
}

TEST(StudyReport, FindsTheSlopeOverSizeWithAnIntervalThatHoldsIt)
{
  const StudyEvaluation study(knownResults(21));
  const auto slopes = study.slopes(Outcome::angle);
  ASSERT_EQ(slopes.size(), 2u);
  EXPECT_EQ(slopes[0].name, "A_mm");
  EXPECT_NEAR(slopes[0].perUnit.value, 30.0, 1.0);
  EXPECT_LT(slopes[0].perUnit.low, 30.0);
  EXPECT_GT(slopes[0].perUnit.high, 30.0);
  EXPECT_GT(slopes[0].perUnit.low, 25.0);
}

TEST(StudyReport, LeavesOutCochleaeInWhichAnInsertionDidNotFinish)
{
  auto results = knownResults(20);
  results[1].insertion.end = analysis::InsertionEnd::outOfOpening;
  results[1].insertion.apical = degrees(0.0);
  const StudyEvaluation study(results);
  EXPECT_NEAR(effectNamed(study.mainEffects(Outcome::angle), "array = long").value, 23.0, 1e-9);
  EXPECT_TRUE(StudyEvaluation(knownResults(2)).mainEffects(Outcome::angle).empty());
}

TEST(StudyReport, TellsDistributionsEffectsAndWhatDidNotFinish)
{
  const test::TemporaryFolder folder;
  auto results = knownResults(20);
  results.back().insertion.end = analysis::InsertionEnd::buckled;
  auto file = StudyFile::openToContinue(
      folder / "study.sqlite", {"Two arrays", "", "abcdef0123456789ff", "0.1.0", 80, 0, 80});
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->append(results));
  const auto report = reportOf(*file);
  ASSERT_TRUE(report) << report.error().message;
  for (const char* part :
       {"# Two arrays\n", "80 insertions: 1 buckled, 79 finished.", "| array = long | 40 | 97.5 (",
        "| A 8.00 to ", "### angular insertion depth, deg", "| per unit of A_mm | ",
        "together, beyond their sum: array = "})
    EXPECT_THAT(report->text, HasSubstr(part));
  ASSERT_EQ(report->figures.size(), 2u);
  const figures::Figure& angle = report->figures[0].second;
  ASSERT_EQ(angle.values.size(), 2u);
  EXPECT_EQ(angle.values[0].label, "array = long");
  EXPECT_EQ(angle.values[0].x.size(), 39u);
  EXPECT_THAT(angle.notes, testing::Contains(HasSubstr("1 buckled")));
}

}  // namespace
}  // namespace perilymph::study
