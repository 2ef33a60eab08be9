// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanReport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "perilymph/analysis/Tonotopy.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/ContactsCsv.h"
#include "perilymph/planning/PlanWords.h"
#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::test {
namespace {

std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields;
  std::istringstream stream(line + ",");  // a last field may be empty
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

TEST(PlanReport, SaysTheSameInJsonAndTables)
{
  const planning::Plan plan = syntheticPlan(101);
  const auto text = planning::planJson(plan);
  ASSERT_TRUE(text) << text.error().message;
  const auto json = nlohmann::json::parse(*text);
  std::istringstream table(planning::arraysCsv(plan));
  std::string head, row;
  std::getline(table, head);
  std::getline(table, row);
  const auto names = fieldsOf(head), values = fieldsOf(row);
  ASSERT_EQ(names.size(), values.size());
  const auto valueOf = [&](const std::string& name) {
    const auto place = std::find(names.begin(), names.end(), name);
    return place == names.end() ? -1.0 : std::stod(values[std::size_t(place - names.begin())]);
  };
  EXPECT_EQ(valueOf("angle_deg_median"), json["arrays"][0]["angle_deg"]["median"].get<double>());
  EXPECT_EQ(valueOf("peak_mN_p95"), json["arrays"][0]["peak_mN"]["p95"].get<double>());
  EXPECT_NEAR(
      valueOf("intended_depth_reached_percent"),
      100.0 * json["arrays"][0]["probability"]["intended_depth_reached"]["value"].get<double>(),
      1e-3);
  EXPECT_EQ(json["arrays"][0]["contacts"].size(), 2u);
  EXPECT_EQ(json["patient"]["B_sd_mm"], 0.2);
  EXPECT_EQ(json["bands_hold"], "90 % at friction 0.12");
  const auto hold = std::ranges::find(names, "bands_hold");
  ASSERT_NE(hold, names.end());
  EXPECT_EQ(values[std::size_t(hold - names.begin())], "90 % at friction 0.12");
}

TEST(PlanReport, CallsQuantilesOfFewSimulationsNoBand)
{
  planning::Plan plan = syntheticPlan(63);
  EXPECT_EQ(planning::bandsHold(plan), "5 to 95 % of 63 simulations at friction 0.12");
  plan = syntheticPlan(64);
  EXPECT_EQ(planning::bandsHold(plan), "90 % at friction 0.12");
  plan.friction = {0.24, 0.59};
  EXPECT_EQ(planning::bandsHold(plan), "90 % at friction 0.24 to 0.59");
  // 0.165 exp(-1.96 0.3465) = 0.0837, 0.165 exp(1.96 0.3465) = 0.3254
  plan.friction = {0.165, 0.165};
  plan.frictionSpread = 0.3465;
  EXPECT_EQ(planning::bandsHold(plan), "90 % over friction 0.08 to 0.33");
  plan.friction = {};  // of a file that does not state it
  EXPECT_EQ(planning::bandsHold(plan), "90 % at one friction");
}

TEST(PlanReport, NamesTheSourceOfEveryDistributionAndWhatIsNotDrawn)
{
  const auto text = planning::planJson(syntheticPlan(20));
  ASSERT_TRUE(text);
  const auto json = nlohmann::json::parse(*text);
  EXPECT_GE(json["sources"].size(), 8u);
  for (const auto& source : json["sources"])
    EXPECT_FALSE(source["source"].get<std::string>().empty()) << source;
  EXPECT_EQ(json["limits"].size(), planning::limitsOfPlans().size());
}

TEST(PlanReport, NamesTheSourceOfATaperThatIsDrawn)
{
  planning::Plan plan = syntheticPlan(20);
  plan.request.arrays = {"flexsoft", "flex28"};
  const auto text = planning::planJson(plan);
  ASSERT_TRUE(text);
  const auto json = nlohmann::json::parse(*text);
  int tapers = 0;
  for (const auto& source : json["sources"]) {
    if (source["table"] != "taper") continue;
    ++tapers;
    EXPECT_EQ(source["file"], "flexsoft.toml");
    EXPECT_EQ(source["confidence"], "low");
  }
  EXPECT_EQ(tapers, 1);
}

TEST(PlanReport, HasARowPerContact)
{
  const std::string csv = planning::contactsCsv(syntheticPlan(20));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 2);
}

/// The first fields of the lines of a table, joined by commas.
std::string firstFields(const std::string& csv)
{
  std::string fields;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);)
    fields += (fields.empty() ? "" : ",") + line.substr(0, line.find(','));
  return fields;
}

TEST(ContactTable, HasAnEntryOfTheDictionaryForEachColumn)
{
  const std::string csv = planning::contactsCsv(syntheticPlan(20));
  EXPECT_EQ(firstFields(planning::contactsDictionaryCsv()),
            "column," + csv.substr(0, csv.find('\n')));
}

TEST(ContactTable, OfOneInsertionStatesPlaceFrequenciesAndMismatch)
{
  const auto file = findByName("array", "plugins/electrodes", "flex28");
  ASSERT_TRUE(file);
  const auto array = electrode::loadArray(*file);
  ASSERT_TRUE(array);
  std::vector<analysis::ContactPosition> contacts(12);
  for (std::size_t i = 0; i < contacts.size(); ++i) contacts[i].number = static_cast<int>(i) + 1;
  contacts[0].isInserted = true;
  contacts[0].angle = degrees(360.0);
  contacts[0].frequency_Hz = 900.0;
  contacts[0].toModiolus = millimeters(0.5);
  const auto csv = planning::insertionContactsCsv("flex28", *array, contacts);
  ASSERT_TRUE(csv) << csv.error().message;
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(*csv);
  for (std::string line; std::getline(lines, line);) rows.push_back(fieldsOf(line));
  ASSERT_EQ(rows.size(), 13u);
  const auto cell = [&](std::size_t row, const char* key) {
    const auto column = std::ranges::find(rows[0], key) - rows[0].begin();
    return rows[row].at(static_cast<std::size_t>(column));
  };
  EXPECT_EQ(cell(1, "angle_deg"), "360");
  EXPECT_EQ(cell(1, "angle_p5_deg"), "");  // one insertion has no band
  EXPECT_EQ(cell(1, "greenwood_Hz"), "900");
  // Stakhovskaya et al. 2007: the spiral ganglion at 360 degrees
  const double ganglion_Hz = std::stod(cell(1, "spiral_ganglion_Hz"));
  EXPECT_NEAR(ganglion_Hz, analysis::spiralGanglionFrequency(degrees(360.0)), 0.01);
  const double filter_Hz = std::stod(cell(1, "filter_Hz"));
  EXPECT_NEAR(std::stod(cell(1, "mismatch_semitones")), 12.0 * std::log2(ganglion_Hz / filter_Hz),
              0.01);
  EXPECT_EQ(cell(2, "draws"), "0");
  EXPECT_EQ(cell(2, "angle_deg"), "");
  EXPECT_GT(std::stod(cell(2, "filter_Hz")), filter_Hz);
}

TEST(PlanReport, DrawsTheBandsOfEachArray)
{
  const auto figures = planning::planFigures(syntheticPlan(101));
  ASSERT_EQ(figures.size(), 5u);
  EXPECT_EQ(figures[0].first, "angle");
  EXPECT_EQ(figures[2].first, "influence-1");
  // two bars an input, the largest first: A explains everything
  const figures::Figure& influence = figures[2].second;
  EXPECT_EQ(influence.bands.size() % 2, 0u);
  EXPECT_NEAR(influence.bands[0].high[0], 100.0, 1e-6);
  EXPECT_GE(influence.bands[0].high[0], influence.bands[2].high[0]);
  const figures::Figure& force = figures[1].second;
  // up to 1 mm of all 101, behind it of ten; both parts join
  EXPECT_EQ(force.bands[0].label, "90 % at friction 0.12");
  EXPECT_EQ(force.bands[0].x, (std::vector<double>{0.0, 0.5, 1.0}));
  EXPECT_EQ(force.bands[1].x, (std::vector<double>{1.0, 1.5}));
  EXPECT_LT(force.bands[1].ink.opacity, force.bands[0].ink.opacity);
  EXPECT_NEAR(force.curves[0].y[0], 51.0, 1e-9);
  EXPECT_EQ(force.curves[0].dash, 0.0);
  EXPECT_GT(force.curves[1].dash, 0.0);
  EXPECT_EQ(force.values[0].x, (std::vector<double>{1.0, 1.5}));
  ASSERT_EQ(force.texts.size(), 2u);
  EXPECT_EQ(force.texts[1].text, "10 of 101");
  EXPECT_GE(force.y.high, 96.0);
}

}  // namespace
}  // namespace perilymph::test
