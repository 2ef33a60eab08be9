// SPDX-License-Identifier: BSD-3-Clause

// The study in which the PDF report of a plan is filed: that whose data made it, or none.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QString>
#include <fstream>
#include <iterator>

#include "PlanReportRig.h"
#include "StudyOfTwoSlices.h"
#include "gui/report/PlanReportPdf.h"
#include "gui/report/ReportIssuer.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(PlanReportPdf, IsHeldByADicomObject)
{
  store(syntheticPlan(8));
  const fs::path file = folder_ / "plan.dcm";
  ASSERT_EQ(report(folder_.path(), file).status, 0);
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_EQ(bytes.substr(128, 4), "DICM");
  EXPECT_THAT(bytes, HasSubstr("%PDF-"));
  EXPECT_THAT(bytes, HasSubstr("P-17"));
}

TEST_F(PlanReportPdf, BecomesPartOfTheStudyInWhichItsPatientWasMeasuredAndOfNoOther)
{
  planning::Plan plan = syntheticPlan(8);
  plan.request.patient.origin.seriesKey = keyOfSeries("1.2.840.99.1");
  store(plan);
  writeStudy(folder_ / "own", "1.2.840.99.1", "Doe^Jane");
  writeStudy(folder_ / "other", "1.2.840.99.2", "Roe^Richard");
  const fs::path file = folder_ / "plan.dcm";
  const auto into = [&](const char* ct, const std::vector<std::string>& more = {}) {
    ProgramCall call = callOf(folder_.path(), file);
    call.arguments.insert(call.arguments.end(), {"--ct", (folder_ / ct).string()});
    call.arguments.insert(call.arguments.end(), more.begin(), more.end());
    return run(call);
  };
  for (const std::vector<std::string>& more : {std::vector<std::string>(), {"--ct-not-compared"}}) {
    const auto other = into("other", more);
    EXPECT_EQ(other.status, 1);
    EXPECT_THAT(other.err, HasSubstr("is not the CT in which this was measured"));
    EXPECT_FALSE(fs::exists(file));
  }
  EXPECT_EQ(into("own").status, 0);
  EXPECT_TRUE(fs::exists(file));
  // A slice of the CT is no place for a report.
  const fs::path slice = fs::directory_iterator(folder_ / "own")->path();
  const std::string bytes = *readWhole(slice);
  fs::rename(slice, folder_ / "own" / "1.dcm");
  ProgramCall onto = callOf(folder_.path(), folder_ / "own" / "1.dcm");
  onto.arguments.insert(onto.arguments.end(), {"--ct", (folder_ / "own").string()});
  const auto refused = run(onto);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("1.dcm, a file of the CT. Give the report another name."));
  EXPECT_TRUE(*readWhole(folder_ / "own" / "1.dcm") == bytes);

  // As of an earlier version: nobody vouches for the series that it states.
  fs::remove(file);
  std::string text = *readWhole(folder_ / "plan.json");
  const auto format = text.find("\"format\": 3");
  const auto seal = text.find(",\n  \"content_sha256\"");
  ASSERT_TRUE(format != std::string::npos && seal != std::string::npos);
  text.erase(seal, text.find('\n', seal + 2) - seal);
  text.replace(format, 11, "\"format\": 1");
  const std::string program = "Perilymph " + version();
  std::ofstream(folder_ / "plan.json")
      << text.replace(text.find(program), program.size(), "Perilymph 0.2.0");
  const auto unsealed = into("own");
  EXPECT_EQ(unsealed.status, 1);
  EXPECT_THAT(unsealed.err, HasSubstr("carries no seal"));
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(into("own", {"--ct-not-compared"}).status, 0);

  fs::remove(file);
  plan.request.patient.origin.seriesKey.clear();
  store(plan);
  const auto unknown = into("own");
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err, HasSubstr("add --ct-not-compared"));
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(into("own", {"--ct-not-compared"}).status, 0);
}

TEST_F(PlanReportPdf, OfAPlanThatWasChangedByHandSaysSoAndIsFiledNowhere)
{
  planning::Plan plan = syntheticPlan(8);
  plan.fingerprint = std::string(64, 'f');
  store(plan);
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  EXPECT_THAT(textOf(pdf()), HasSubstr(std::string(16, 'f')));
  std::string text = *readWhole(folder_ / "plan.json");
  const auto place = text.find("\"side\": \"right\"");
  ASSERT_NE(place, std::string::npos);
  std::ofstream(folder_ / "plan.json")
      << std::string(text).replace(place, 15, "\"side\": \"left\"");
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  EXPECT_THAT(textOf(pdf()), HasSubstr("changed by hand"));
  EXPECT_THAT(textOf(pdf()), Not(HasSubstr(std::string(16, 'f'))));
  writeStudy(folder_ / "ct", "1.2.840.99.1", "Doe^Jane");
  ProgramCall call = callOf(folder_.path(), folder_ / "plan.dcm");
  call.arguments.insert(call.arguments.end(),
                        {"--ct", (folder_ / "ct").string(), "--ct-not-compared"});
  const auto filed = run(call);
  EXPECT_EQ(filed.status, 1);
  EXPECT_THAT(filed.err, HasSubstr("was changed by hand"));
  // a side that is none
  std::ofstream(folder_ / "plan.json") << text.replace(place, 15, "\"side\": \"lefs\"");
  const auto refused = report(folder_.path(), pdf());
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("side is \"lefs\"; it must be right or left"));
}

TEST_F(PlanReportPdf, OfMeasuresThatWereChangedByHandSaysSoAndIsFiledNowhere)
{
  planning::Plan plan = syntheticPlan(8);
  plan.request.patient.origin = {"perilymph 0.3.0", keyOfSeries("1.2.840.99.1"), "", "RW"};
  plan.request.patient.seal = Seal::changed;
  store(plan);
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  const std::string text = textOf(pdf());
  EXPECT_THAT(text, HasSubstr("were changed by hand after the program wrote them"));
  EXPECT_THAT(text, HasSubstr("Cochlea, measures changed by hand"));
  EXPECT_THAT(text, HasSubstr("none: the measures were changed"));
  EXPECT_THAT(text, Not(HasSubstr("perilymph 0.3.0")));
  EXPECT_THAT(text, Not(HasSubstr("CT measurements")));
  writeStudy(folder_ / "ct", "1.2.840.99.1", "Doe^Jane");
  for (const bool isCompared : {true, false}) {
    ProgramCall call = callOf(folder_.path(), folder_ / "plan.dcm");
    call.arguments.insert(call.arguments.end(), {"--ct", (folder_ / "ct").string()});
    if (!isCompared) call.arguments.emplace_back("--ct-not-compared");
    const auto filed = run(call);
    EXPECT_EQ(filed.status, 1);
    EXPECT_THAT(filed.err, HasSubstr("is of measures that were changed by hand"));
    EXPECT_FALSE(fs::exists(folder_ / "plan.dcm"));
  }
}

}  // namespace
}  // namespace perilymph::test
