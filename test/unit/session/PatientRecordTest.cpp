// SPDX-License-Identifier: BSD-3-Clause

// What is kept of a patient besides the measures.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "PatientRecordRig.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::session {
namespace {

using testing::HasSubstr;

TEST_F(PatientRecords, AreReadAsTheyWereWritten)
{
  EXPECT_EQ(*loadPatientRecord(file_), PatientRecord());
  ASSERT_TRUE(savePatientRecord(record_, file_));
  EXPECT_TRUE(fs::exists(folder_ / "patients/P-017-left.json"));
  EXPECT_EQ(*loadPatientRecord(file_), record_);
}

TEST_F(PatientRecords, RefuseWhatTheyCannotKeep)
{
  for (const PatientRecord& bad :
       {PatientRecord{{""}, "", false}, PatientRecord{{"a,b"}, "", false},
        PatientRecord{{"EAS", "EAS"}, "", false}, PatientRecord{{std::string(25, 'x')}, "", false},
        PatientRecord{{}, std::string(maxNotes + 1, 'x'), false},
        PatientRecord{std::vector<std::string>(maxTags + 1, "x"), "", false},
        PatientRecord{{}, "", false, {{"Doe, Jane", "2026-11-20T09:30:00Z"}}},
        PatientRecord{{}, "", false, {{"0a1b", "yesterday"}}},
        PatientRecord{{}, "", false, {maxScans + 1, {"0a1b", "2026-11-20T09:30:00Z"}}}}) {
    EXPECT_FALSE(savePatientRecord(bad, file_));
    EXPECT_FALSE(fs::exists(recordFileOf(file_)));
  }
}

TEST_F(PatientRecords, RefuseHostileFilesInOneSentence)
{
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("{\"format\": 1}"),
        std::string("{\"format\": 1, \"tags\": [7], \"notes\": \"\", \"archived\": false}"),
        std::string("{\"format\": 1, \"tags\": [\"\"], \"notes\": \"\", \"archived\": false}"),
        std::string("{\"format\": 2}"),
        std::string("{\"format\": 2, \"tags\": [], \"notes\": \"\", \"archived\": false}"),
        std::string(100'000, '['), std::string(40'000, '[')}) {
    std::ofstream(recordFileOf(file_)) << text;
    const auto record = loadPatientRecord(file_);
    ASSERT_FALSE(record) << text.substr(0, 60);
    EXPECT_THAT(record.error().message, HasSubstr("P-017-left.json"));
  }
}

TEST_F(PatientRecords, OfANewerProgramSaySo)
{
  for (const char* format : {"4", "4294967297", "18446744073709551615", "1e300"}) {
    std::ofstream(recordFileOf(file_))
        << "{\"format\": " << format << R"(, "tags": [], "notes": "", "archived": false})";
    const auto record = loadPatientRecord(file_);
    ASSERT_FALSE(record) << format;
    EXPECT_THAT(record.error().message, HasSubstr("newer program")) << format;
  }
}

TEST_F(PatientRecords, StayAsTheyWereWhereTheDiskIsFull)
{
  ASSERT_TRUE(savePatientRecord(record_, file_));
  // a limit of the size of files fails writes as a full disk does
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{512, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto saved = savePatientRecord({{"other"}, std::string(maxNotes, 'x'), false}, file_);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(saved);
  EXPECT_EQ(*loadPatientRecord(file_), record_);
  EXPECT_EQ(filesIn(folder_ / "patients").size(), 2u);
}

TEST_F(PatientRecords, KeepEveryVersionOfTheMeasures)
{
  const auto first = *anatomy::loadPatient(file_);  // as a program before wrote it
  ASSERT_TRUE(savePatientVersion(patientWith(9.2), file_, factsAt("2026-11-20T09:30:00Z"), false));
  ASSERT_TRUE(savePatientVersion(patientWith(9.2), file_, factsAt("2026-11-21T09:30:00Z"), false));
  ASSERT_TRUE(savePatientVersion(patientWith(9.4), file_, factsAt("2026-11-22T09:30:00Z"), false));
  const auto record = loadPatientRecord(file_);
  ASSERT_TRUE(record) << record.error().message;
  ASSERT_EQ(record->versions.size(), 3u);
  EXPECT_EQ(record->versions[0].patient, anatomy::patientText(first));
  EXPECT_EQ(record->versions[1].patient, anatomy::patientText(patientWith(9.2)));
  EXPECT_EQ(record->versions[1].savedUtc, "2026-11-20T09:30:00Z");
  EXPECT_EQ(record->versions[1].landmarks, factsAt("").landmarks);
  EXPECT_EQ(record->versions[1].warnings, factsAt("").warnings);
  EXPECT_FALSE(record->versions[1].program.empty());
  EXPECT_EQ(record->versions[2].patient, anatomy::patientText(patientWith(9.4)));
  EXPECT_EQ(record->scans.size(), 1u);
  EXPECT_EQ(anatomy::loadPatient(file_)->basalTurn->a, millimeters(9.4));
  // for other programs: values with their 95 % intervals
  const auto json = nlohmann::json::parse(*readWhole(recordFileOf(file_)));
  const auto& a = json.at("versions")[1].at("measures").at("A_mm");
  EXPECT_NEAR(a.at("value").get<double>(), 9.2, 1e-9);
  EXPECT_NEAR(a.at("ci95")[0].get<double>(), 9.2 - 0.196, 1e-9);
  EXPECT_NEAR(a.at("ci95")[1].get<double>(), 9.2 + 0.196, 1e-9);
}

TEST_F(PatientRecords, KeepPlansInsertionsAndOutcomes)
{
  auto record = loadPatientRecord(file_);
  record->plans = {{"2026-11-20T09:30:00Z", "P-017-left-01234567", "3 arrays"}};
  record->insertions = {{"2026-11-20T10:30:00Z", "one.insertion", "FLEX28"}};
  record->outcomes = {{"2026-12-20T09:30:00Z", std::string(64, 'c'), "{\"format\": 1}"}};
  const auto saved = savePatientRecord(*record, file_);
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(*loadPatientRecord(file_), *record);
  for (auto list : {0, 1, 2}) {  // none of them can be lost
    PatientRecord other = *saved;
    if (list == 0) other.plans.clear();
    if (list == 1) other.insertions[0].name = "two.insertion";
    if (list == 2) other.outcomes.clear();
    const auto lost = savePatientRecord(other, file_);
    ASSERT_FALSE(lost);
    EXPECT_THAT(lost.error().message, HasSubstr("would be lost"));
  }
}

TEST_F(PatientRecords, OfFormatOneAreReadAndKept)
{
  std::ofstream(recordFileOf(file_))
      << R"({"format": 1, "tags": ["EAS"], "notes": "first look", "archived": true, "scans": []})";
  auto record = loadPatientRecord(file_);
  ASSERT_TRUE(record) << record.error().message;
  EXPECT_EQ(record->notes, "first look");
  EXPECT_EQ(record->seal, Seal::absent);
  EXPECT_FALSE(record->isChangedByHand);
  ASSERT_TRUE(savePatientVersion(patientWith(9.2), file_, factsAt("2026-11-20T09:30:00Z"), false));
  EXPECT_EQ(loadPatientRecord(file_)->notes, "first look");
  EXPECT_EQ(loadPatientRecord(file_)->seal, Seal::intact);
}

TEST_F(PatientRecords, WithVersionsArePassedOffAsFormatOneInVain)
{
  ASSERT_TRUE(savePatientVersion(patientWith(9.2), file_, factsAt("2026-11-20T09:30:00Z"), false));
  std::string text = *readWhole(recordFileOf(file_));
  text.replace(text.find("\"format\": 2"), 11, "\"format\": 1");
  const auto seal = text.find(",\n  \"content_sha256\"");
  text.replace(seal, text.size() - seal, "\n}\n");
  ASSERT_TRUE(writeWhole(recordFileOf(file_), text));
  const auto record = loadPatientRecord(file_);
  ASSERT_TRUE(record) << record.error().message;
  EXPECT_TRUE(record->isChangedByHand);
  EXPECT_EQ(record->versions.size(), 2u);
}

TEST_F(PatientRecords, AddNoScanOfMeasuresThatWereChangedByHand)
{
  ASSERT_TRUE(savePatientVersion(patientWith(9.2), file_, factsAt("2026-11-20T09:30:00Z"), false));
  std::string text = *readWhole(file_);
  text.replace(text.find(std::string(64, 'b')), 64, std::string(64, 'd'));
  ASSERT_TRUE(writeWhole(file_, text));
  const auto changed = anatomy::loadPatient(file_);
  ASSERT_TRUE(changed) << changed.error().message;
  ASSERT_TRUE(savePatientVersion(*changed, file_, factsAt("2026-11-21T09:30:00Z"), false));
  const auto record = loadPatientRecord(file_);
  ASSERT_EQ(record->scans.size(), 1u);
  EXPECT_EQ(record->scans[0].series, std::string(64, 'b'));
  ASSERT_EQ(record->versions.size(), 3u);
  EXPECT_EQ(anatomy::patientIn(record->versions[2].patient, "third")->seal, Seal::changed);
  EXPECT_EQ(anatomy::loadPatient(file_)->seal, Seal::changed);
}

TEST_F(PatientRecords, ThatWereChangedByHandSaySoForEver)
{
  auto saved = savePatientRecord(record_, file_);
  ASSERT_TRUE(saved) << saved.error().message;
  std::string text = *readWhole(recordFileOf(file_));
  text.replace(text.find("narrow"), 6, "wide  ");
  std::ofstream(recordFileOf(file_)) << text;
  auto changed = loadPatientRecord(file_);
  ASSERT_TRUE(changed) << changed.error().message;
  EXPECT_EQ(changed->seal, Seal::changed);
  EXPECT_TRUE(changed->isChangedByHand);
  changed->tags = {};
  ASSERT_TRUE(savePatientRecord(*changed, file_));
  EXPECT_EQ(loadPatientRecord(file_)->seal, Seal::intact);
  EXPECT_TRUE(loadPatientRecord(file_)->isChangedByHand);
}

TEST_F(PatientRecords, OfAnotherProgramAreNotReplaced)
{
  const auto mine = loadPatientRecord(file_);
  ASSERT_TRUE(savePatientRecord(record_, file_));  // by another program meanwhile
  PatientRecord other = *mine;
  other.notes = "mine";
  const auto saved = savePatientRecord(other, file_);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message, HasSubstr("was changed by another program meanwhile"));
  EXPECT_EQ(*loadPatientRecord(file_), record_);
  // nor those that cannot be read, or are of a newer program
  for (const char* text : {"{\"format\": 4}", "no JSON"}) {
    std::ofstream(recordFileOf(file_)) << text;
    EXPECT_FALSE(savePatientRecord(other, file_));
    EXPECT_FALSE(
        savePatientVersion(patientWith(9.2), file_, factsAt("2026-11-20T09:30:00Z"), false));
    EXPECT_EQ(*readWhole(recordFileOf(file_)), text);
    EXPECT_EQ(anatomy::loadPatient(file_)->basalTurn->a, millimeters(9.1));
  }
}

TEST_F(PatientRecords, ThatWereRemovedAreWrittenAgain)
{
  const auto saved = savePatientRecord(record_, file_);
  ASSERT_TRUE(saved);
  fs::remove(recordFileOf(file_));
  EXPECT_TRUE(savePatientRecord(*saved, file_));
  EXPECT_EQ(*loadPatientRecord(file_), record_);
  // but not beside a patient that was renamed
  fs::remove(recordFileOf(file_));
  fs::remove(file_);
  EXPECT_FALSE(savePatientRecord(*saved, file_));
  EXPECT_FALSE(fs::exists(recordFileOf(file_)));
}

TEST_F(PatientRecords, AreNotMadeOverAPatientThatCannotBeRead)
{
  const std::string newer = "label = \"P-017\"\nside = \"left\"\nfrom_a_newer_program = 1\n";
  std::ofstream(file_) << newer;
  for (const bool isNew : {true, false}) {
    const auto saved =
        savePatientVersion(patientWith(9.2), file_, factsAt("2026-11-20T09:30:00Z"), isNew);
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().message, HasSubstr("not replaced"));
    EXPECT_EQ(*readWhole(file_), newer);
  }
}

TEST_F(PatientRecords, LoseNoNoteOfTwoProgramsAtOnce)
{
  // Each adds fifty insertions to the record; each entry is there afterwards.
  const int programs = 3, each = 50;
  for (int i = 0; i < programs; ++i)
    if (::fork() == 0) {
      for (int k = 0; k < each; ++k) {
        const auto change = [&] {
          return static_cast<bool>(changePatientRecord(file_, [&](PatientRecord& record) {
            record.insertions.push_back(
                {"2026-11-20T10:30:00Z", std::to_string(i) + "-" + std::to_string(k), "FLEX28"});
          }));
        };
        // on a busy machine one may come too late again and again, and is told so
        bool isChanged = false;
        for (int attempt = 0; attempt < 30 && !isChanged; ++attempt) isChanged = change();
        if (!isChanged) ::_exit(1);
      }
      ::_exit(0);
    }
  for (int i = 0; i < programs; ++i) {
    int status = 0;
    ::wait(&status);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(loadPatientRecord(file_)->insertions.size(), std::size_t(programs * each));
  EXPECT_EQ(filesIn(folder_ / "patients").size(), 2u);  // no lock is left
}

}  // namespace
}  // namespace perilymph::session
