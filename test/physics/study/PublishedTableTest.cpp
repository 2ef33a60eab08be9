// SPDX-License-Identifier: BSD-3-Clause

// The table of results in the guide is what the program computes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "perilymph/test/Places.h"
#include "perilymph/test/Tolerance.h"
#include "perilymph/validation/ValidationReport.h"

namespace perilymph::validation {
namespace {

/// The simulated forces of the guide's table [mN], by the first word of their row.
std::map<std::string, double> tableOfTheGuide()
{
  std::ifstream page(test::projectFolder() / "resources/guide/constants.md");
  std::map<std::string, double> forces;
  std::string line;
  while (std::getline(page, line) && line != "### Results") continue;
  while (std::getline(page, line) && line.rfind("## ", 0) != 0) {
    std::istringstream row(line);
    std::string cell, name, experiment, simulated;
    std::getline(row, cell, '|');
    if (!std::getline(row, name, '|') || !std::getline(row, experiment, '|') ||
        !std::getline(row, simulated, '|'))
      continue;
    std::istringstream number(simulated);
    double force = 0.0;
    if (!(number >> force)) continue;
    const auto from = name.find_first_not_of(' ');
    forces[name.substr(from, name.find_last_not_of(' ') + 1 - from)] = force;
  }
  return forces;
}

/// Expects a mean of a few insertions to agree with that of the table's 200.
void expectAgreement(const std::map<std::string, double>& table, const std::string& name,
                     const analysis::SampleStatistics& few)
{
  const auto row = table.find(name);
  ASSERT_NE(row, table.end()) << name;
  // three standard errors of the few, and half of the last digit
  EXPECT_NEAR(1e3 * few.mean, row->second, 3e3 * few.standardError + 0.05) << name;
}

TEST(PublishedTable, IsThatOfTheGuideWithinTheErrorOfFewInsertions)
{
  const auto references = validationReferences();
  ASSERT_TRUE(references);
  ValidationRequest request = *shippedValidation(*references);
  request.runs = 12;
  request.runsPerSource = 0;
  request.jobs = 2;
  const auto result = validate(request, {});
  ASSERT_TRUE(result) << result.error().message;
  const auto table = tableOfTheGuide();
  ASSERT_EQ(result->anchors.size(), 4u);
  expectAgreement(table, "10.6 mm, fitted", result->anchors[0].simulator);
  expectAgreement(table, "11.8 mm", result->anchors[1].simulator);
  expectAgreement(table, "15.4 mm", result->anchors[2].simulator);
  expectAgreement(table, "16.5 mm", result->anchors[3].simulator);
  ASSERT_EQ(result->intervals.size(), 2u);
  expectAgreement(table, "12.6 mm", result->intervals[0].simulator);
  expectAgreement(table, "14.6 mm", result->intervals[1].simulator);
  ASSERT_TRUE(result->rawPeak && result->rib);
  expectAgreement(table, "raw, basal turn", *result->rawPeak);
  expectAgreement(table, "raw, before the first rib", result->rib->before);
  expectAgreement(table, "raw, at the first rib", result->rib->peak);
}

}  // namespace
}  // namespace perilymph::validation
