// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ClinicalReports.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "perilymph/foundation/Resources.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::analysis {
namespace {

using testing::HasSubstr;

const ClinicalEvidence& shipped()
{
  const auto& evidence = ClinicalEvidence::shipped();
  EXPECT_TRUE(evidence) << evidence.error().message;
  return *evidence;
}

TEST(ShippedReports, AreOfShippedArrays)
{
  EXPECT_GT(shipped().reports().size(), 10u);
  for (const ClinicalReport& each : shipped().reports())
    for (const std::string& array : each.arrays)
      EXPECT_TRUE(findByName("array", "plugins/electrodes", array)) << array;
}

TEST(ShippedReports, HoldWhatTheAbstractsPrint)
{
  // O'Connell 2017: FLEX24, median 408 degrees, quartiles 373 and 449
  const ClinicalReport* flex24 = shipped().find("flex24", ReportedQuantity::angle);
  ASSERT_NE(flex24, nullptr);
  EXPECT_EQ(numbersOf(*flex24), "408 (quartiles 373 to 449)");
  EXPECT_EQ(flex24->n, 48);
  EXPECT_EQ(flex24->nOf, "FLEX24 + FLEX28 + Standard");
  EXPECT_EQ(flex24->valueOf, "");
  EXPECT_EQ(shipped().find("flex24", ReportedQuantity::peakForce)->valueOf,
            "an array that is not named");
  EXPECT_EQ(numbersOf(*shipped().find("flexsoft", ReportedQuantity::angle)),
            "641 (range 533 to 751)");
  EXPECT_EQ(numbersOf(*shipped().find("hifocus-slimj", ReportedQuantity::angle)), "401 (SD 41)");
  // Canfarotta 2021: 49 of 51; Newcombe's intervals are by Wilson, as here
  const ClinicalReport* complete = shipped().find("flexsoft", ReportedQuantity::complete);
  ASSERT_NE(complete, nullptr);
  EXPECT_EQ(numbersOf(*complete), "49 of 51");
  EXPECT_NEAR(complete->low, 86.8, 0.05);
  EXPECT_NEAR(complete->high, 98.9, 0.05);
  EXPECT_EQ(shipped().find("flexsoft", ReportedQuantity::endForce)->value, std::nullopt);
  EXPECT_EQ(shipped().findAll("flexsoft", ReportedQuantity::angle).size(), 2u);
  EXPECT_EQ(shipped().find("contour", ReportedQuantity::angle), nullptr);
}

TEST(ShippedReports, AgreeWithTheRangesOfTheClinicalTable)
{
  // resources/clinical/insertion-angles.toml and rates.toml, which the table is judged by
  const auto find = [](const char* array, ReportedQuantity quantity) {
    return shipped().find(array, quantity);
  };
  const auto text = [](const char* file) {
    std::ifstream stream(resource(file));
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string angles = text("resources/clinical/insertion-angles.toml");
  for (const char* array : {"flex24", "flex28", "medel-standard", "flexsoft", "hifocus-slimj"}) {
    const std::string rest = angles.substr(angles.find("\"" + std::string(array) + "\""));
    const auto number = [&rest](const char* key) {
      return std::stod(rest.substr(rest.find(key) + std::string(key).size()));
    };
    const ClinicalReport* report = find(array, ReportedQuantity::angle);
    ASSERT_NE(report, nullptr) << array;
    EXPECT_EQ(report->value, number("median_deg = ")) << array;
    EXPECT_EQ(report->low, number("low_deg = ")) << array;
    EXPECT_EQ(report->high, number("high_deg = ")) << array;
  }
  EXPECT_THAT(text("resources/clinical/rates.toml"), HasSubstr("count = 49\nof = 51"));
}

TEST(ShippedVerdicts, AreThoseOfTheClinicalTable)
{
  const auto& evidence = ClinicalEvidence::shipped();
  ASSERT_TRUE(evidence) << evidence.error().message;
  std::ifstream table(resource("resources/clinical/clinical-table.csv"));
  const std::regex ofArray(
      "\"((?:angular depth|complete insertion) of ([a-z0-9-]+))\",(?:[^,]*,){8}([^,]*),.*");
  std::map<std::string, std::vector<std::string>> missed;
  int rows = 0;
  for (std::string line; std::getline(table, line);) {
    std::smatch found;
    if (!std::regex_match(line, found, ofArray)) continue;
    ++rows;
    missed[found[2]];
    if (found[3] == "miss") missed[found[2]].push_back(found[1]);
  }
  EXPECT_EQ(rows, 6);
  for (const auto& [array, misses] : missed) {
    EXPECT_EQ(evidence->missedRows(array), misses) << array;
    EXPECT_EQ(evidence->verdictOf(array), misses.empty() ? ArrayVerdict::hit : ArrayVerdict::miss);
  }
}

TEST(Verdicts, MarkAnArrayWithAMissedRow)
{
  const test::TemporaryFolder folder;
  const auto write = [&](const char* name, const char* text) {
    std::ofstream(folder / name) << text;
    return folder / name;
  };
  const auto reports = write("reports.toml", "label = \"none\"\n");
  const auto verdicts = write("verdicts.toml", R"(
label = "some"
source = "a test"
[[verdict]]
array = "a"
row = "angle"
verdict = "hit"
[[verdict]]
array = "a"
row = "rate"
verdict = "miss"
[[verdict]]
array = "b"
row = "angle"
verdict = "hit"
)");
  const auto evidence = ClinicalEvidence::read(reports, verdicts);
  ASSERT_TRUE(evidence) << evidence.error().message;
  EXPECT_EQ(evidence->verdictOf("a"), ArrayVerdict::miss);
  EXPECT_THAT(evidence->missedRows("a"), testing::ElementsAre("rate"));
  EXPECT_EQ(evidence->verdictOf("b"), ArrayVerdict::hit);
  EXPECT_EQ(evidence->verdictOf("c"), ArrayVerdict::notTested);
}

TEST(AReport, IsRefusedWithItsFileAndReason)
{
  const test::TemporaryFolder folder;
  const auto verdicts = folder / "verdicts.toml";
  std::ofstream(verdicts) << "label = \"none\"\nsource = \"a test\"\n";
  const std::string end =
      "\ndefinition = \"d\"\nreference = \"r\"\nsource = \"s\"\nread = \"abstract\"\n"
      "confidence = \"low\"\n";
  const auto refusalOf = [&](const std::string& lines) {
    const auto file = folder / "reports.toml";
    std::ofstream(file) << "label = \"l\"\n[[report]]\narrays = [\"a\"]\n" << lines << end;
    const auto evidence = ClinicalEvidence::read(file, verdicts);
    return evidence ? std::string("accepted") : std::string(evidence.error().message);
  };
  EXPECT_EQ(refusalOf("quantity = \"complete\"\nstatistic = \"proportion\"\ncount = 3\nn = 4"),
            "accepted");
  EXPECT_THAT(
      refusalOf("quantity = \"complete\"\nstatistic = \"proportion\"\ncount = 5\nn = 4"),
      testing::AllOf(HasSubstr("reports.toml"), HasSubstr("count"), HasSubstr("exceeds n")));
  EXPECT_THAT(refusalOf("quantity = \"angle\"\nstatistic = \"median\"\ncount = 5\nn = 9"),
              HasSubstr("give value"));
  EXPECT_THAT(refusalOf("quantity = \"angle\"\nstatistic = \"median\"\nvalue = 500.0\n"
                        "spread = \"quartiles\"\nlow = 510.0\nhigh = 520.0"),
              HasSubstr("outside of low to high"));
  EXPECT_THAT(refusalOf("quantity = \"angle\"\nstatistic = \"none\""), HasSubstr("needs a value"));
  EXPECT_THAT(refusalOf("quantity = \"depth\"\nstatistic = \"none\""), HasSubstr("angle"));
  EXPECT_THAT(refusalOf("quantity = \"angle\"\nstatistic = \"mean\"\nvalue = 2000.0"),
              HasSubstr("2000"));
}

}  // namespace
}  // namespace perilymph::analysis
