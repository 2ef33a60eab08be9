// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/ClinicLibrary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "StopLengths.h"
#include "perilymph/outcome/OutcomeText.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlanFolder.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/session/PatientRecord.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

/// A library with one patient, a plan of one simulation and an outcome.
class Library : public testing::Test {
protected:
  void SetUp() override
  {
    fs::create_directories(folders().patients);
    fs::create_directories(planFolder());
    patient_ = measuredPatient();
    patient_.label = "P-017";
    ASSERT_TRUE(
        session::savePatientVersion(patient_, patientFile(), {"2026-01-02T10:00:00Z"}, true));
    planning::PlanRequest request;
    request.patient = patient_;
    request.arrays = {"flex28"};
    request.draws = 1;
    const auto plan = planning::makePlan(request, planFolder() / planning::planDrawsFile);
    ASSERT_TRUE(plan) << plan.error().message;
    const auto json = planning::planJson(*plan);
    ASSERT_TRUE(json);
    std::ofstream(planFolder() / planning::planJsonFile) << *json;
    std::ofstream(planFolder() / planning::planPatientFile) << anatomy::patientText(patient_);
    std::ofstream(planFolder() / planning::planRequestFile)
        << "made = \"2026-01-03T10:00:00Z\"\narrays = [\"flex28\"]\n"
           "scenario = \"surgery-flex28\"\ndraws = 1\nseed = 1\nshown_draws = 1\n"
           "is_complete = true\n";
    number_ = plan->fingerprint;
  }
  planning::RegistryFolders folders() const
  {
    return {folder_.path() / "patients", folder_.path() / "plans", folder_.path() / "sessions"};
  }
  fs::path planFolder() const { return folders().plans / "one"; }
  fs::path patientFile() const { return folders().patients / "P-017-right.toml"; }
  /// Adds an outcome of the patient.
  void implant(outcome::StopReason reason, const std::string& utc = "2026-02-20T10:00:00Z",
               const std::string& plan = "")
  {
    outcome::OutcomeContent content;
    content.found.array = "flex28";
    content.found.side = patient_.side;
    content.found.contactsInside = 12;
    content.found.angularInsertionDepth_deg = {480.0, 4.0};
    content.found.tipAngle_deg = 490.0;
    content.found.insertedLength_mm = 24.0;
    content.found.insertedLengthSd_mm = 0.3;
    for (int number = 1; number <= 12; ++number) {
      outcome::FoundContact contact;
      contact.number = number;
      contact.isInside = true;
      content.found.contacts.push_back(contact);
    }
    content.surgery.array = "flex28";
    content.surgery.stopReason = reason;
    content.surgery.daysToCt = 30;
    content.plan = plan;
    const auto changed =
        session::changePatientRecord(patientFile(), [&](session::PatientRecord& record) {
          record.outcomes.push_back({utc, std::string(64, 'a'), outcome::outcomeJson(content)});
        });
    ASSERT_TRUE(changed) << changed.error().message;
  }

  TemporaryFolder folder_;
  anatomy::Patient patient_;
  std::string number_;
};

TEST_F(Library, GivesAnOutcomeThePlanThatWasMadeBeforeItsSurgery)
{
  implant(outcome::StopReason::resistance, "2026-02-20T10:00:00Z", number_);
  const auto library = outcome::readOutcomes(folders());
  ASSERT_TRUE(library) << library.error().message;
  for (const Sentence& note : library->notes) ADD_FAILURE() << note;
  ASSERT_EQ(library->outcomes.size(), 1u);
  const outcome::MeasuredOutcome& outcome = library->outcomes.front();
  EXPECT_EQ(outcome.surgeryUtc, "2026-01-21");
  EXPECT_EQ(outcome.array, "flex28");
  EXPECT_DOUBLE_EQ(outcome.depth_mm.value, 24.0);
  EXPECT_EQ(outcome.plan.depths_mm.size(), 1u);
  EXPECT_NEAR(outcome.plan.friction, 0.165, 1e-9);
  EXPECT_NEAR(outcome.plan.insertable_mm, 28.0, 1.0);
  ASSERT_TRUE(outcome.plan.stops);
  EXPECT_EQ(outcome.plan.stops->draws.size(), 1u);
  EXPECT_NEAR(outcome.plan.stops->logFrictionSd, std::sqrt(0.283 * 0.283 + 0.04), 1e-3);
  EXPECT_TRUE(fs::exists(planFolder() / outcome::stopLengthsFile(0)));
  const auto clinic = outcome::compareOutcomes(library->outcomes);
  ASSERT_TRUE(clinic) << clinic.error().message;
  EXPECT_EQ(clinic->resistance.count(outcome::Evidence::resisted), 1u);
  for (const std::string& text : {outcome::outcomesJson(*clinic), outcome::outcomesCsv(*clinic)}) {
    EXPECT_EQ(text.find("P-017"), std::string::npos);
    EXPECT_EQ(text.find("2026-"), std::string::npos);
  }
}

TEST_F(Library, ComputesNoStopLengthsForAnOutcomeThatTellsNothingAboutResistance)
{
  implant(outcome::StopReason::unknown);
  const auto library = outcome::readOutcomes(folders());
  ASSERT_TRUE(library);
  ASSERT_EQ(library->outcomes.size(), 1u);
  EXPECT_FALSE(library->outcomes.front().plan.stops);
  EXPECT_FALSE(fs::exists(planFolder() / outcome::stopLengthsFile(0)));
}

TEST_F(Library, LeavesOutAnOutcomeWhosePlanWasMadeAfterTheSurgery)
{
  implant(outcome::StopReason::resistance, "2026-01-30T10:00:00Z");  // surgery on 31 December
  const auto library = outcome::readOutcomes(folders());
  ASSERT_TRUE(library);
  EXPECT_TRUE(library->outcomes.empty());
  ASSERT_EQ(library->notes.size(), 1u);
  EXPECT_NE(library->notes[0].find("no plan of flex28 was made for it before the surgery"),
            std::string::npos);
}

TEST_F(Library, SaysThatAnOutcomeCannotBeRead)
{
  ASSERT_TRUE(session::changePatientRecord(patientFile(), [](session::PatientRecord& record) {
    record.outcomes.push_back({"2026-02-20T10:00:00Z", std::string(64, 'a'), "{}"});
  }));
  const auto library = outcome::readOutcomes(folders());
  ASSERT_TRUE(library);
  EXPECT_TRUE(library->outcomes.empty());
  EXPECT_EQ(library->notes.size(), 1u);
}

TEST(SurgeryDay, IsSomeDaysBefore)
{
  EXPECT_EQ(outcome::surgeryDay("2026-03-01T09:30:00Z", 1), "2026-02-28");
  EXPECT_EQ(outcome::surgeryDay("2024-03-01T09:30:00Z", 1), "2024-02-29");
  EXPECT_EQ(outcome::surgeryDay("2026-01-01", 0), "2026-01-01");
  EXPECT_EQ(outcome::surgeryDay("yesterday", 0), "");
}

}  // namespace
}  // namespace perilymph::test
