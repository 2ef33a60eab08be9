// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <sstream>

namespace perilymph::study {
namespace {

using testing::HasSubstr;
using testing::Not;

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

StudyColumns columnsOf(std::vector<StudyResult> results)
{
  const std::size_t count = results.size();
  return {{"Two arrays", "", "abcdef0123456789ff", "0.1.0", count, 0, count}, std::move(results)};
}

constexpr auto ran = StudySelection::ran;
constexpr auto complete = StudySelection::complete;
constexpr const char* angle = "angle_deg";

Estimate effectNamed(const std::vector<Effect>& effects, const std::string& name)
{
  for (const Effect& each : effects)
    if (each.name == name) return each.size;
  ADD_FAILURE() << "There is no effect " << name;
  return {};
}

TEST(StudyReport, FindsTheEffectsThatArePresent)
{
  const StudyColumns columns = columnsOf(knownResults(20));
  const StudyEvaluation study(columns);
  EXPECT_EQ(study.ranges(), std::vector<std::string>{"speed_mm_s"});
  const auto effects = study.mainEffects(angle, complete);
  ASSERT_EQ(effects.size(), 4u);
  // Half of the difference between the levels, with half of what they do together.
  EXPECT_NEAR(effectNamed(effects, "array = long").value, 25.0 - 2.0, 1e-9);
  EXPECT_NEAR(effectNamed(effects, "array = short").value, -23.0, 1e-9);
  EXPECT_NEAR(effectNamed(effects, "friction = tissue").value, -10.0 - 2.0, 1e-9);
  const auto together = study.interactions(angle, complete);
  ASSERT_EQ(together.size(), 4u);
  EXPECT_NEAR(effectNamed(together, "array = long, friction = tissue").value, -2.0, 1e-9);
  // Nothing varies between cochleae but the mean, so these are known exactly.
  EXPECT_NEAR(together.front().size.high - together.front().size.low, 0.0, 1e-9);
}

TEST(StudyReport, FindsTheSlopeOverSizeWithAnIntervalThatHoldsIt)
{
  const StudyColumns columns = columnsOf(knownResults(21));
  const StudyEvaluation study(columns);
  const auto slopes = study.slopes(angle, complete);
  ASSERT_EQ(slopes.size(), 2u);
  EXPECT_EQ(slopes[0].name, "A_mm");
  EXPECT_NEAR(slopes[0].perUnit.value, 30.0, 1.0);
  EXPECT_LT(slopes[0].perUnit.low, 30.0);
  EXPECT_GT(slopes[0].perUnit.high, 30.0);
  EXPECT_GT(slopes[0].perUnit.low, 25.0);
}

TEST(StudyReport, HasStudentsIntervalOfAnEffectInFewCochleae)
{
  // three cochleae; the long array gains 20, 26 and 23 degrees over the short one: effects 10, 13, 11.5
  std::vector<StudyResult> results;
  for (const double gain : {20.0, 26.0, 23.0})
    for (const bool isLong : {false, true}) {
      StudyResult result;
      result.number = results.size();
      result.cochlea = "virtual " + std::to_string(results.size() / 2 + 1);
      result.settings = {{"array", isLong ? "long" : "short"}};
      result.a_mm = 9.0;
      result.insertion.end = analysis::InsertionEnd::finished;
      result.insertion.apical = degrees(400.0 + (isLong ? gain : 0.0));
      results.push_back(result);
    }
  const StudyColumns columns = columnsOf(results);
  const Estimate found =
      effectNamed(StudyEvaluation(columns).mainEffects(angle, complete), "array = long");
  EXPECT_NEAR(found.value, 11.5, 1e-9);
  EXPECT_NEAR(found.high, 11.5 + 4.30265273 * 1.5 / std::sqrt(3.0), 1e-6);  // t(2), sd 1.5
}

TEST(StudyReport, LeavesOutOfCompleteOnesCochleaeInWhichAnInsertionStopped)
{
  auto results = knownResults(20);
  results[1].insertion.end = analysis::InsertionEnd::outOfOpening;
  results[1].insertion.apical = degrees(0.0);
  const StudyColumns columns = columnsOf(results);
  const StudyEvaluation study(columns);
  EXPECT_NEAR(effectNamed(study.mainEffects(angle, complete), "array = long").value, 23.0, 1e-9);
  // of all that ran it counts: the short array with tissue has 0 degrees in the first cochlea
  const double lost = inDegrees(knownResults(20)[1].insertion.apical);
  EXPECT_NEAR(effectNamed(study.mainEffects(angle, ran), "array = long").value,
              23.0 + lost / 4.0 / 20.0, 1e-9);
  const StudyColumns few = columnsOf(knownResults(2));
  EXPECT_TRUE(StudyEvaluation(few).mainEffects(angle, complete).empty());
}

/// The fields of the table rows that begin with a text.
std::vector<std::string> rowsOf(const std::string& text, const std::string& begin)
{
  std::vector<std::string> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(begin)) rows.push_back(line);
  return rows;
}

TEST(StudyReport, HasBothSelectionsWithTheNumbersOfTheSummary)
{
  auto results = knownResults(20);
  results.back().insertion.end = analysis::InsertionEnd::buckled;
  results.back().insertion.apical = degrees(90.0);
  const StudyColumns columns = columnsOf(results);
  const StudyReport report = reportOf(columns);
  for (const char* part :
       {"# Two arrays\n", "80 insertions: 1 buckled, 79 finished.",
        "| array = long | 40 | 97.5 (87.1 to 99.6) | 1 | 0 |", "| A 8.00 to ",
        "### angular insertion depth, deg, of all that ran",
        "### angular insertion depth, deg, of complete", "| per unit of A_mm | ",
        "together, beyond their sum: array = ", "*Complete*: those that reached their full depth"})
    EXPECT_THAT(report.text, HasSubstr(part));
  const StudySummary summary = summaryOf(columns, columns.rows({}), {"A_mm", "angle_deg", "array"});
  const auto number = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return std::string(text);
  };
  // the rate, then the distribution of each selection, then the slope
  const auto rows = rowsOf(report.text, "| array = long | ");
  ASSERT_EQ(rows.size(), 14u);  // then the effects on five quantities
  for (const StudySelection selection : studySelections) {
    const StudySample& sample = summary.groups[1].samples[selection];
    const std::string& row = rows[selection == ran ? 1 : 2];
    EXPECT_THAT(
        row, testing::StartsWith("| array = long | " + std::to_string(selection == ran ? 40 : 39) +
                                 " | " + number(sample.quartiles[0]->value) + " (" +
                                 number(sample.quartiles[0]->low) + " to " +
                                 number(sample.quartiles[0]->high) + "); " +
                                 number(sample.means[0]->mean) + " |"));
    EXPECT_THAT(rows[3], HasSubstr("| " + number(sample.trend->slope().value) + " ("));
  }
  EXPECT_THAT(report.text, HasSubstr("| array: short - long | 40 pairs, 20 cochleae | "));
  EXPECT_THAT(report.text, HasSubstr("| array: short - long | 39 pairs, 20 cochleae | "));
}

TEST(StudyReport, GivesTheIntervalOfARateOfFewInsertions)
{
  auto results = knownResults(3);  // 6 of each array
  results[2].insertion.end = analysis::InsertionEnd::jammed;
  const StudyColumns columns = columnsOf(results);
  // Wilson of 5 of 6: 0.4365 to 0.9699 (R: binom.confint(5, 6, methods = "wilson"))
  EXPECT_THAT(reportOf(columns).text,
              HasSubstr("| array = long | 6 | 5 of 6 (44 to 97) | 1 | 0 |"));
}

TEST(StudyReport, ShowsArraysByTheirNamesAndOtherFilesWithoutFolders)
{
  auto results = knownResults(20);
  for (StudyResult& each : results) {
    each.settings[0].second = each.settings[0].second == "long" ? "flex28" : "flex24";
    each.settings[1].second = "/home/somebody/frictions/" + each.settings[1].second + ".toml";
  }
  const StudyColumns columns = columnsOf(results);
  const StudyReport report = reportOf(columns);
  for (const char* part : {"| array = FLEX28 | 40 |", "| array: FLEX24 - FLEX28 | 40 pairs",
                           "| friction = tissue | 40 |", "beyond their sum: array = FLEX"})
    EXPECT_THAT(report.text, HasSubstr(part));
  EXPECT_THAT(report.text, Not(HasSubstr("/home/")));
  EXPECT_EQ(report.figures[0].second.values[1].label, "array = FLEX28");
  // two that would look the same stay as they are
  for (StudyResult& each : results)
    each.settings[1].second = each.settings[1].second == "/home/somebody/frictions/soap.toml"
                                  ? "other/tissue.toml"
                                  : "one/tissue.toml";
  const StudyColumns alike = columnsOf(results);
  EXPECT_EQ(alike.factor("friction")->shown, alike.factor("friction")->levels);
}

TEST(StudyReport, DrawsStoppedInsertionsAsRings)
{
  auto results = knownResults(20);
  results.back().insertion.end = analysis::InsertionEnd::buckled;
  const StudyColumns columns = columnsOf(results);
  const StudyReport report = reportOf(columns);
  ASSERT_EQ(report.figures.size(), 2u);
  const figures::Figure& figure = report.figures[0].second;
  ASSERT_EQ(figure.values.size(), 3u);
  EXPECT_EQ(figure.values[0].label, "array = short");
  EXPECT_EQ(figure.values[1].label, "array = long");
  EXPECT_EQ(figure.values[1].x.size(), 39u);
  EXPECT_EQ(figure.values[2].label, "array = long, stopped");
  EXPECT_EQ(figure.values[2].x.size(), 1u);
  EXPECT_EQ(figure.values[2].shape, figures::MarkerShape::ring);
}

}  // namespace
}  // namespace perilymph::study
