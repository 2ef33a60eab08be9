// SPDX-License-Identifier: BSD-3-Clause

// The clinical table of the guide is what the rule makes of the shipped insertions, and those are what
// the program computes.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "Table.h"
#include "perilymph/test/Places.h"
#include "perilymph/validation/ClinicalPrediction.h"

namespace perilymph::validation {
namespace {

std::vector<analysis::ClinicalInsertion> shippedInsertions()
{
  std::vector<analysis::ClinicalInsertion> insertions;
  for (const test::Row& row :
       test::csvRows(test::projectFolder() / "resources/clinical/clinical-insertions.csv")) {
    analysis::ClinicalInsertion one;
    one.array = row.at("array");
    one.seed = std::stoull(row.at("seed"));
    one.patient = std::stoull(row.at("patient"));
    one.apical = degrees(std::stod(row.at("apical_deg")));
    one.depth = millimeters(std::stod(row.at("depth_mm")));
    one.endForce = newtons(std::stod(row.at("end_N")));
    one.peak = newtons(std::stod(row.at("peak_N")));
    one.sharedFriction = std::stod(row.at("shared_ln_friction"));
    if (row.at("end") == haptics::nameOf(haptics::InsertionEnd::buckled))
      one.end = haptics::InsertionEnd::buckled;
    one.isTranslocated = row.at("is_translocated") == "true";
    one.contacts.resize(std::stoul(row.at("contacts")));
    for (std::size_t i = 0; i < std::stoul(row.at("contacts_inside")); ++i)
      one.contacts.at(i).isInserted = true;
    insertions.push_back(one);
  }
  return insertions;
}

TEST(PublishedClinic, HasTheRowsThatTheRuleMakesOfItsInsertions)
{
  const auto insertions = shippedInsertions();
  ASSERT_EQ(insertions.size(), 5u * 36u);
  const auto rows = clinicalRows(insertions);
  ASSERT_TRUE(rows) << rows.error().message;
  std::map<std::string, test::Row> shipped;
  for (const test::Row& row :
       test::csvRows(test::projectFolder() / "resources/clinical/clinical-table.csv"))
    shipped[row.at("quantity")] = row;
  for (const ClinicalRow& row : *rows) {
    const auto there = shipped.find(row.quantity);
    ASSERT_NE(there, shipped.end()) << row.quantity;
    const auto number = [&](const char* column) { return std::stod(there->second.at(column)); };
    EXPECT_NEAR(row.median, number("median"), 1e-9) << row.quantity;
    EXPECT_NEAR(row.published, number("published_median"), 1e-9) << row.quantity;
    EXPECT_NEAR(row.tolerance, number("tolerance"), 1e-6) << row.quantity;
    EXPECT_NEAR(row.power, number("power"), 1e-9) << row.quantity;
    EXPECT_EQ(row.verdict == RowVerdict::hit, there->second.at("verdict") == "hit") << row.quantity;
    EXPECT_EQ(row.spread == RowVerdict::hit, there->second.at("spread_verdict") == "hit")
        << row.quantity;
  }
}

TEST(PublishedClinic, IsPrintedInTheGuide)
{
  std::map<std::string, test::Row> shipped;
  for (const test::Row& row :
       test::csvRows(test::projectFolder() / "resources/clinical/clinical-table.csv"))
    shipped[row.at("quantity")] = row;
  const auto page =
      test::pageRows(test::projectFolder() / "resources/guide/clinical.md", "## The table");
  int printed = 0;
  for (const std::vector<std::string>& cells : page) {
    const auto row = shipped.find(cells.front());
    if (row == shipped.end()) continue;
    ++printed;
    ASSERT_GE(cells.size(), 5u);
    const auto number = [&](const char* column) { return std::stod(row->second.at(column)); };
    if (row->second.at("runs") == "0")
      EXPECT_EQ(cells[2], "–") << cells.front();
    else
      EXPECT_NEAR(std::stod(cells[2]), number("median"), 0.5 + 1e-9) << cells.front();
    const std::string verdict = row->second.at("verdict");
    EXPECT_NE(cells[4].find(verdict == "not judged" ? "not counted" : verdict), std::string::npos)
        << cells.front();
  }
  EXPECT_GE(printed, 10);
}

/// Two of the arrays, whose insertions are short.
TEST(PublishedClinic, IsRepeatedByTheProgram)
{
  ClinicalRequest request;
  request.arrays = {"flex24", "hifocus-slimj"};
  request.patients = 2;
  request.jobs = 2;
  const auto result = predictClinic(request, {});
  ASSERT_TRUE(result) << result.error().message;
  int repeated = 0;
  for (const analysis::ClinicalInsertion& published : shippedInsertions())
    for (const analysis::ClinicalInsertion& now : result->insertions) {
      if (now.array != published.array || now.seed != published.seed ||
          now.patient != published.patient)
        continue;
      ++repeated;
      const std::string which = now.array + ", patient " + std::to_string(now.patient);
      EXPECT_NEAR(inDegrees(now.apical), inDegrees(published.apical), 0.5) << which;
      EXPECT_NEAR(inMillinewtons(now.peak), inMillinewtons(published.peak), 0.5) << which;
      EXPECT_EQ(now.sharedFriction, published.sharedFriction) << which;
    }
  EXPECT_EQ(repeated, 4);
}

}  // namespace
}  // namespace perilymph::validation
