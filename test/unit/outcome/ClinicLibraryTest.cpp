// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/ClinicLibrary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>

#include "StopLengths.h"
#include "perilymph/database/Database.h"
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

constexpr const char* surgeon = "P-017";
constexpr const char* other = "P-018";

/// A text with one part replaced.
std::string replaced(std::string text, const std::string& part, const std::string& by)
{
  const std::size_t place = text.find(part);
  EXPECT_NE(place, std::string::npos) << part;
  return place == std::string::npos ? text : text.replace(place, part.size(), by);
}

std::string contentOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const fs::path& file, const std::string& text)
{
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

/// Notes which of some words stand in a sentence as a phrase of their own, and which as plain text.
void collect(const Sentence& sentence, const std::set<std::string>& words,
             std::set<std::string>& asPhrase, std::set<std::string>& asText)
{
  if (words.count(sentence) > 0)
    (sentence.phrase() != nullptr ? asPhrase : asText).insert(sentence);
  for (const Sentence& value : sentence.values()) collect(value, words, asPhrase, asText);
}

void halve(const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); }

/// A library with two patients, P-017 and P-018, and a plan of one simulation of each.
class Library : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    whole_ = new TemporaryFolder;
    for (const char* code : {surgeon, other}) {
      anatomy::Patient patient = measuredPatient();
      patient.label = code;
      const fs::path folder = whole_->path() / "plans" / code;
      fs::create_directories(whole_->path() / "patients");
      fs::create_directories(folder);
      ASSERT_TRUE(session::savePatientVersion(
          patient, whole_->path() / "patients" / (std::string(code) + "-right.toml"),
          {"2026-01-02T10:00:00Z"}, true));
      planning::PlanRequest request;
      request.patient = patient;
      request.arrays = {"flex28"};
      request.draws = 1;
      const auto plan = planning::makePlan(request, folder / planning::planDrawsFile);
      ASSERT_TRUE(plan) << plan.error().message;
      const auto json = planning::planJson(*plan);
      ASSERT_TRUE(json);
      std::ofstream(folder / planning::planJsonFile) << *json;
      std::ofstream(folder / planning::planPatientFile) << anatomy::patientText(patient);
      std::ofstream(folder / planning::planRequestFile)
          << "made = \"2026-01-03T10:00:00Z\"\narrays = [\"flex28\"]\n"
             "scenario = \"surgery-flex28\"\ndraws = 1\nseed = 1\nshown_draws = 1\n"
             "is_complete = true\n";
      if (code == surgeon) number_ = plan->fingerprint;
    }
  }
  static void TearDownTestSuite()
  {
    delete whole_;
    whole_ = nullptr;
  }
  void SetUp() override { restore(); }
  /// The library as it was made, without outcomes.
  void restore()
  {
    fs::remove_all(folder_.path());
    fs::create_directories(folder_.path());
    fs::copy(whole_->path(), folder_.path(), fs::copy_options::recursive);
  }
  planning::RegistryFolders folders() const
  {
    return {folder_.path() / "patients", folder_.path() / "plans", folder_.path() / "sessions"};
  }
  fs::path planFolder(const char* code = surgeon) const { return folders().plans / code; }
  fs::path patientFile(const char* code = surgeon) const
  {
    return folders().patients / (std::string(code) + "-right.toml");
  }
  /// An outcome of either patient.
  static outcome::OutcomeContent found(outcome::StopReason reason = outcome::StopReason::unknown)
  {
    outcome::OutcomeContent content;
    content.found.array = "flex28";
    content.found.side = measuredPatient().side;
    content.found.contactsInside = 12;
    content.found.angularInsertionDepth_deg = {480.0, 4.0};
    content.found.tipAngle_deg = 490.0;
    content.found.insertedLength_mm = 24.0;
    content.found.insertedLengthSd_mm = 0.3;
    for (int number = 1; number <= 12; ++number) {
      outcome::FoundContact contact;
      contact.number = number;
      contact.isInside = true;
      contact.angle_deg = {510.0 - 30.0 * number, 4.0};
      content.found.contacts.push_back(contact);
    }
    content.surgery.array = "flex28";
    content.surgery.stopReason = reason;
    content.surgery.daysToCt = 30;
    content.ctAge_days = 0;
    return content;
  }
  /// Adds an outcome to a patient's record.
  void implant(const std::string& content, const char* code, const std::string& utc,
               const std::string& series)
  {
    const auto changed =
        session::changePatientRecord(patientFile(code), [&](session::PatientRecord& record) {
          record.outcomes.push_back({utc, series, content});
        });
    ASSERT_TRUE(changed) << changed.error().message;
  }
  void implant(outcome::StopReason reason, const std::string& utc = "2026-02-20T10:00:00Z",
               const std::string& plan = "")
  {
    outcome::OutcomeContent content = found(reason);
    content.plan = plan;
    implant(outcome::outcomeJson(content), surgeon, utc, std::string(64, 'a'));
  }
  /// Adds an outcome of the other patient.
  void implantOther(const std::string& content, const std::string& utc = "2026-02-21T10:00:00Z",
                    const std::string& series = std::string(64, 'b'))
  {
    implant(content, other, utc, series);
  }

  static inline TemporaryFolder* whole_ = nullptr;
  static inline std::string number_;
  TemporaryFolder folder_;
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

/// The plan was made on 3 January 2026.
TEST_F(Library, CountsTheDayOfSurgeryFromTheCtAndNotFromWhenTheOutcomeWasSaved)
{
  struct Case {
    const char* saved;
    std::optional<int> ctAge_days, daysToCt;
    bool isPredicted;
    const char* said;
  };
  const Case cases[] = {
      // CT on 6 January, surgery on the 2nd, the 3rd, the 4th; saved soon and months later
      {"2026-01-10T10:00:00Z", 4, 4, false, "no plan of flex28 was made for it before"},
      {"2026-01-10T10:00:00Z", 4, 3, true, ""},
      {"2026-01-10T10:00:00Z", 4, 2, true, ""},
      {"2026-07-10T10:00:00Z", 185, 4, false, "no plan of flex28 was made for it before"},
      {"2026-07-10T10:00:00Z", 185, 3, true, ""},
      // the clinic's day is ahead of Greenwich's
      {"2026-01-05T23:00:00Z", -1, 3, true, ""},
      {"2026-07-10T10:00:00Z", {}, 4, false, "the day of its CT is not known"},
      {"2026-07-10T10:00:00Z", 4, {}, false, "the days from surgery to its CT are not known"},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(each.saved + std::to_string(each.daysToCt.value_or(-1)));
    restore();
    outcome::OutcomeContent content = found();
    content.surgery.daysToCt = each.daysToCt;
    content.ctAge_days = each.ctAge_days;
    const auto changed = session::changePatientRecord(patientFile(), [&](session::PatientRecord&
                                                                             record) {
      record.outcomes.push_back({each.saved, std::string(64, 'a'), outcome::outcomeJson(content)});
    });
    ASSERT_TRUE(changed) << changed.error().message;
    const auto library = outcome::readOutcomes(folders());
    ASSERT_TRUE(library) << library.error().message;
    EXPECT_EQ(library->outcomes.size(), each.isPredicted ? 1u : 0u);
    EXPECT_EQ(library->leftOut.withoutDay, each.ctAge_days && each.daysToCt ? 0u : 1u);
    ASSERT_EQ(library->notes.size(), each.isPredicted ? 0u : 1u);
    if (!each.isPredicted) {
      EXPECT_NE(library->notes.front().find(each.said), std::string::npos)
          << library->notes.front();
    }
  }
}

TEST_F(Library, ComputesStopLengthsAgainThatAreOfNoUseAndSaysSoOnce)
{
  implant(outcome::StopReason::resistance);
  ASSERT_TRUE(outcome::readOutcomes(folders()));
  write(planFolder() / outcome::stopLengthsFile(0), "no table");
  const auto renewed = outcome::readOutcomes(folders());
  ASSERT_TRUE(renewed);
  ASSERT_EQ(renewed->outcomes.size(), 1u);
  EXPECT_TRUE(renewed->outcomes.front().plan.stops);
  ASSERT_EQ(renewed->notes.size(), 1u);
  EXPECT_NE(renewed->notes[0].find("computed again, for 1 plans"), std::string::npos);
  const auto again = outcome::readOutcomes(folders());
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->notes.empty());
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

/// What is wrong with one ear: how, what the sentence must name, and as what it is counted.
struct Fault {
  const char* what;
  std::function<void()> make;
  std::vector<std::string> named;
  std::size_t outcome::LeftOut::*count;
};

/// Whatever is wrong with one ear, it alone is left out, with a sentence that names it, and counted.
TEST_F(Library, ComparesTheOtherEarsWhateverIsWrongWithOne)
{
  const std::string good = outcome::outcomeJson(found());
  const auto with = [&](const auto& change) {
    outcome::OutcomeContent content = found();
    change(content);
    return outcome::outcomeJson(content);
  };
  const std::string ear = "P-018, right ear is left out: ", toml = "P-018-right.toml",
                    record = "P-018-right.json";
  using outcome::LeftOut;
  const auto inPlan = [&](const char* file) { return planFolder(other) / file; };
  const std::vector<Fault> faults{
      {"truncated outcome",
       [&] { implantOther(good.substr(0, good.size() / 2)); },
       {ear, "not JSON"},
       &LeftOut::unreadable},
      {"empty outcome", [&] { implantOther(""); }, {ear, "not JSON"}, &LeftOut::unreadable},
      {"NaN",
       [&] { implantOther(replaced(good, "24.0", "NaN")); },
       {ear, "not JSON"},
       &LeftOut::unreadable},
      {"beyond any number",
       [&] { implantOther(replaced(good, "24.0", "1e999")); },
       {ear, "not JSON"},
       &LeftOut::unreadable},
      {"value of another type",
       [&] { implantOther(replaced(good, "24.0", "\"deep\"")); },
       {ear, "inserted_length_mm", "deep", "a number"},
       &LeftOut::unreadable},
      {"two values of one name",
       [&] { implantOther(replaced(good, "\"fold\"", "\"fold\": true, \"fold\"")); },
       {ear, "it states \"fold\" twice"},
       &LeftOut::unreadable},
      {"another format",
       [&] { implantOther(replaced(good, "\"format\": 1", "\"format\": 7")); },
       {ear, "format 7"},
       &LeftOut::unreadable},
      {"deep nesting",
       [&] {
         implantOther(replaced(
             good, "\"fold\"",
             "\"deep\": " + std::string(200000, '[') + std::string(200000, ']') + ", \"fold\""));
       },
       {ear, "nested"},
       &LeftOut::unreadable},
      {"truncated record",
       [&] { implantOther(good), halve(patientFile(other).replace_extension(".json")); },
       {record},
       &LeftOut::unreadable},
      {"record of a newer program",
       [&] {
         implantOther(good);
         const fs::path file = patientFile(other).replace_extension(".json");
         write(file, replaced(contentOf(file), "\"format\": 2", "\"format\": 9"));
       },
       {record, "newer"},
       &LeftOut::unreadable},
      {"truncated patient",
       [&] { implantOther(good), halve(patientFile(other)); },
       {toml},
       &LeftOut::unreadable},
      {"error wider than any ear",
       [&] { implantOther(with([](auto& c) { c.found.insertedLengthSd_mm = 1e5; })); },
       {ear, "The inserted length [mm]", "100000", "0 to 120"},
       &LeftOut::impossible},
      {"angle that no ear has",
       [&] {
         implantOther(with([](auto& c) {
           c.found.angularInsertionDepth_deg.value = c.found.contacts[0].angle_deg.value = 1500.0;
         }));
       },
       {ear, "The angular insertion depth [degrees]", "1500", "1100"},
       &LeftOut::impossible},
      {"two depths",
       [&] {
         implantOther(with([](auto& c) { c.found.angularInsertionDepth_deg.value = 300.0; }));
       },
       {ear, "300", "480"},
       &LeftOut::impossible},
      {"two arrays",
       [&] { implantOther(with([](auto& c) { c.surgery.array = "flex24"; })); },
       {ear, "flex28", "flex24"},
       &LeftOut::impossible},
      {"two sides",
       [&] { implantOther(with([](auto& c) { c.found.side = anatomy::Side::left; })); },
       {ear, "left"},
       &LeftOut::impossible},
      {"two series",
       [&] { implantOther(with([](auto& c) { c.series = std::string(64, 'c'); })); },
       {ear, "cccc", "bbbb"},
       &LeftOut::impossible},
      {"a day to come",
       [&] { implantOther(good, "2999-02-20T10:00:00Z"); },
       {ear, "2999-02-20"},
       &LeftOut::impossible},
      {"no day",
       [&] { implantOther(good, "2026-02-31T10:00:00Z"); },
       {ear, "2026-02-31"},
       &LeftOut::impossible},
      {"a plan of another array",
       [&] { implantOther(with([](auto& c) { c.found.array = c.surgery.array = "flex24"; })); },
       {ear, "no plan of flex24"},
       &LeftOut::withoutPlan},
      {"a plan that is not there",
       [&] { implantOther(with([](auto& c) { c.plan = std::string(64, 'd'); })); },
       {ear, "dddd", "flex28"},
       &LeftOut::withoutPlan},
      {"a plan without a day",
       [&] {
         implantOther(good);
         const fs::path file = inPlan(planning::planRequestFile);
         write(file, replaced(contentOf(file), "2026-01-03T10:00:00Z", ""));
       },
       {ear, "no plan of flex28"},
       &LeftOut::withoutPlan},
      {"truncated request",
       [&] { implantOther(good), halve(inPlan(planning::planRequestFile)); },
       {planning::planRequestFile, ear},
       &LeftOut::withoutPlan},
      {"truncated patient of a plan",
       [&] { implantOther(good), halve(inPlan(planning::planPatientFile)); },
       {planning::planPatientFile, ear},
       &LeftOut::withoutPlan},
      {"truncated simulations",
       [&] { implantOther(good), halve(inPlan(planning::planDrawsFile)); },
       {ear, planning::planDrawsFile},
       &LeftOut::withoutPlan},
      {"no simulations",
       [&] { implantOther(good), fs::remove(inPlan(planning::planDrawsFile)); },
       {ear, planning::planDrawsFile},
       &LeftOut::withoutPlan},
      {"simulations that were changed",
       [&] {
         implantOther(good);
         auto draws = database::Database::openNew(inPlan(planning::planDrawsFile));
         ASSERT_TRUE(draws);
         ASSERT_TRUE(
             draws->run("UPDATE insertion SET content = json_set(content, '$.tilt_deg', 1.0)"));
       },
       {ear, planning::planDrawsFile, "changed"},
       &LeftOut::withoutPlan},
      {"one ear in two files",
       [&] {
         fs::copy(patientFile(), patientFile().parent_path() / "copy.toml");
         fs::copy(patientFile().replace_extension(".json"),
                  patientFile().parent_path() / "copy.json");
       },
       {"P-017, right ear of ", "copy.toml", "P-017-right.toml"},
       &LeftOut::twice},
  };
  // what is no name, number or path is shown in the user's language
  const std::set<std::string> words{"left ear", "right ear", "The inserted length [mm]",
                                    "The angular insertion depth [degrees]"};
  std::set<std::string> asPhrase, asText;
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.what);
    restore();
    implant(outcome::StopReason::unknown);
    fault.make();
    const auto library = outcome::readOutcomes(folders());
    ASSERT_TRUE(library) << library.error().message;
    ASSERT_EQ(library->outcomes.size(), 1u);
    EXPECT_EQ(library->patients.front().label, surgeon);
    EXPECT_EQ(library->leftOut.all(), 1u);
    EXPECT_EQ(library->leftOut.*fault.count, 1u);
    std::string notes;
    for (const Sentence& each : library->notes) {
      notes += each + "\n";
      collect(each, words, asPhrase, asText);
    }
    for (const std::string& each : fault.named)
      EXPECT_NE(notes.find(each), std::string::npos) << each << "\n" << notes;
    const auto clinic = outcome::compareOutcomes(library->outcomes, library->leftOut);
    ASSERT_TRUE(clinic) << clinic.error().message;
    EXPECT_NE(outcome::outcomesJson(*clinic).find("\"left_out\": {\n    \"ears\": 1"),
              std::string::npos);
  }
  EXPECT_EQ(asPhrase, words);
  EXPECT_TRUE(asText.empty()) << *asText.begin();
}

TEST_F(Library, LeavesOutBothPatientsThatHaveOneCt)
{
  implant(outcome::StopReason::unknown);
  implantOther(outcome::outcomeJson(found()), "2026-02-21T10:00:00Z", std::string(64, 'a'));
  const auto library = outcome::readOutcomes(folders());
  ASSERT_TRUE(library);
  EXPECT_TRUE(library->outcomes.empty());
  EXPECT_EQ(library->leftOut.twice, 2u);
  ASSERT_EQ(library->notes.size(), 2u);
  EXPECT_NE(library->notes[0].find("P-017, right ear is left out"), std::string::npos);
  EXPECT_NE(library->notes[0].find("also that of P-018"), std::string::npos);
  EXPECT_NE(library->notes[1].find("also that of P-017"), std::string::npos);
}

TEST_F(Library, ComparesAnOutcomeThatStandsTwiceInOneRecordOnce)
{
  for (int i = 0; i < 2; ++i) implant(outcome::StopReason::unknown);
  const auto library = outcome::readOutcomes(folders());
  ASSERT_TRUE(library);
  EXPECT_EQ(library->outcomes.size(), 1u);
  EXPECT_EQ(library->leftOut.all(), 0u);
}

TEST_F(Library, ComparesAnOutcomeOfARecordThatWasChangedByHandAndSaysSo)
{
  implant(outcome::StopReason::unknown);
  const fs::path file = patientFile().replace_extension(".json");
  write(file, replaced(contentOf(file), "24.0", "23.0"));
  const auto library = outcome::readOutcomes(folders());
  ASSERT_TRUE(library);
  ASSERT_EQ(library->outcomes.size(), 1u);
  EXPECT_DOUBLE_EQ(library->outcomes.front().depth_mm.value, 23.0);
  ASSERT_EQ(library->notes.size(), 1u);
  EXPECT_NE(library->notes[0].find("changed by hand"), std::string::npos);
}

TEST(DayBefore, CountsByTheCalendar)
{
  EXPECT_EQ(outcome::dayBefore("2026-03-01T09:30:00Z", 1), "2026-02-28");
  EXPECT_EQ(outcome::dayBefore("2024-03-01T09:30:00Z", 1), "2024-02-29");
  EXPECT_EQ(outcome::dayBefore("2026-01-01", 0), "2026-01-01");
  EXPECT_EQ(outcome::dayBefore("yesterday", 0), "");
}

}  // namespace
}  // namespace perilymph::test
