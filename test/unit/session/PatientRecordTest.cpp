// SPDX-License-Identifier: BSD-3-Clause

// What is kept of a patient besides the measures, and a patient as a folder.

#include "perilymph/session/PatientRecord.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <map>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class PatientRecords : public testing::Test {
protected:
  void SetUp() override
  {
    for (const char* name : {"patients", "recordings", "other", "others"})
      fs::create_directories(folder_ / name);
    anatomy::Patient patient;
    patient.label = "P-017";
    patient.side = anatomy::Side::left;
    patient.basalTurn = anatomy::BasalTurn{millimeters(9.1), millimeters(6.7), std::nullopt};
    ASSERT_TRUE(anatomy::savePatient(patient, file_));
  }

  /// The files below a folder.
  static std::vector<std::string> filesIn(const fs::path& folder)
  {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (!entry.is_directory()) names.push_back(fs::relative(entry.path(), folder).string());
    return names;
  }

  test::TemporaryFolder folder_;
  fs::path file_ = folder_ / "patients/P-017-left.toml";
  PatientRecord record_{{"revision", "EAS"},
                        "Second look.\nRound window narrow.",
                        true,
                        {{std::string(64, 'a'), "2026-11-20T09:30:00Z"}}};
};

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
        std::string("{\"format\": 2}"), std::string(100'000, '['), std::string(40'000, '[')}) {
    std::ofstream(recordFileOf(file_)) << text;
    const auto record = loadPatientRecord(file_);
    ASSERT_FALSE(record) << text.substr(0, 60);
    EXPECT_THAT(record.error().message, HasSubstr("P-017-left.json"));
  }
}

TEST_F(PatientRecords, OfANewerProgramSaySo)
{
  for (const char* format : {"2", "4294967297", "18446744073709551615", "1e300"}) {
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

TEST_F(PatientRecords, TravelAsAFolderWithTheInsertions)
{
  ASSERT_TRUE(savePatientRecord(record_, file_));
  std::ofstream(folder_ / "recordings/one.insertion") << "a recording";
  const fs::path exported = folder_ / "P-017";
  ASSERT_TRUE(exportPatient(file_, {folder_ / "recordings/one.insertion"}, exported));
  EXPECT_THAT(filesIn(exported), testing::UnorderedElementsAre("patient.toml", "record.json",
                                                               "insertions/one.insertion"));

  const auto imported = importPatient(exported, folder_ / "other", folder_ / "others");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(*imported, folder_ / "other/P-017-left.toml");
  EXPECT_EQ(*loadPatientRecord(*imported), record_);
  const auto patient = anatomy::loadPatient(*imported);
  ASSERT_TRUE(patient);
  EXPECT_EQ(patient->label, "P-017");
  EXPECT_EQ(patient->basalTurn->a, millimeters(9.1));
  std::ifstream stream(folder_ / "others/one.insertion");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "a recording");
}

TEST_F(PatientRecords, ReplaceNothingWhenTheyTravel)
{
  const fs::path exported = folder_ / "P-017";
  std::ofstream(folder_ / "recordings/one.insertion") << "a recording";
  ASSERT_TRUE(exportPatient(file_, {folder_ / "recordings/one.insertion"}, exported));
  EXPECT_FALSE(exportPatient(file_, {}, exported));
  const auto twice = importPatient(exported, folder_ / "patients", folder_ / "others");
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().message, HasSubstr("P-017"));
  EXPECT_TRUE(filesIn(folder_ / "others").empty());
  EXPECT_FALSE(importPatient(exported, folder_ / "other", folder_ / "recordings"));
  EXPECT_TRUE(filesIn(folder_ / "other").empty());
}

/// Everything below a folder, links as themselves, with the contents of files.
std::map<std::string, std::string> treeOf(const fs::path& folder)
{
  std::map<std::string, std::string> tree;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    std::string& content = tree[fs::relative(entry.path(), folder).string()];
    if (entry.is_symlink()) content = "-> " + fs::read_symlink(entry.path()).string();
    if (entry.is_symlink() || !entry.is_regular_file()) continue;
    std::ifstream stream(entry.path());
    content.assign(std::istreambuf_iterator<char>(stream), {});
  }
  return tree;
}

TEST_F(PatientRecords, LeaveNothingOfAnExportThatFailed)
{
  const auto before = treeOf(folder_.path());
  EXPECT_FALSE(exportPatient(file_, {folder_ / "recordings/absent.insertion"}, folder_ / "P-017"));
  EXPECT_EQ(treeOf(folder_.path()), before);
}

// Whatever stands beside the new folder is the user's.
TEST_F(PatientRecords, TouchNothingThatIsThereWhenTheyTravel)
{
  fs::create_directories(folder_ / "P-017.part/insertions");
  std::ofstream(folder_ / "P-017.part/thesis") << "three years";
  fs::create_directory(folder_ / "a");
  fs::create_directory_symlink(folder_ / "a", folder_ / "P-018.part");
  fs::create_directory_symlink(folder_ / "a", folder_ / "P-019");
  fs::create_symlink("nowhere", folder_ / "P-020");
  std::ofstream(folder_ / "recordings/one.insertion") << "a recording";
  auto before = treeOf(folder_.path());
  for (const char* name : {"P-017", "P-018", "P-019", "P-020"})
    EXPECT_FALSE(exportPatient(file_, {folder_ / "recordings/absent.insertion"}, folder_ / name));
  for (const char* name : {"P-019", "P-020", "a"})
    EXPECT_FALSE(exportPatient(file_, {}, folder_ / name)) << name;
  EXPECT_EQ(treeOf(folder_.path()), before);

  for (const char* name : {"P-017", "P-018"}) {
    const fs::path exported = folder_ / name;
    ASSERT_TRUE(exportPatient(file_, {folder_ / "recordings/one.insertion"}, exported));
    EXPECT_FALSE(fs::is_symlink(exported));
    EXPECT_THAT(filesIn(exported), testing::UnorderedElementsAre("patient.toml", "record.json",
                                                                 "insertions/one.insertion"));
    EXPECT_EQ(fs::status(exported).permissions(), fs::perms::owner_all);
    EXPECT_EQ(fs::status(exported / "record.json").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
    fs::remove_all(exported);
  }
  EXPECT_EQ(treeOf(folder_.path()), before);
}

TEST_F(PatientRecords, StopTravelingWhenTheyAreAsked)
{
  std::vector<fs::path> recordings;
  for (const char* name : {"one", "two", "three"}) {
    recordings.push_back(folder_ / "recordings" / (std::string(name) + ".insertion"));
    std::ofstream(recordings.back()) << std::string(3'000'000, 'x');
  }
  ASSERT_TRUE(exportPatient(file_, recordings, folder_ / "whole"));
  const auto before = treeOf(folder_.path());
  for (const std::uintmax_t end : {0u, 1'000'000u, 4'000'000u, 8'000'000u}) {
    std::uintmax_t last = 0;
    const CopyProgress stop = [&](std::uintmax_t done, std::uintmax_t all) {
      EXPECT_GE(done, last);
      EXPECT_EQ(all, 9'000'000u);
      last = done;
      return done < end;
    };
    const auto exported = exportPatient(file_, recordings, folder_ / "P-017", stop);
    ASSERT_FALSE(exported);
    EXPECT_THAT(exported.error().message, HasSubstr("canceled"));
    last = 0;
    const auto imported =
        importPatient(folder_ / "whole", folder_ / "other", folder_ / "others", stop);
    ASSERT_FALSE(imported);
    EXPECT_THAT(imported.error().message, HasSubstr("canceled"));
    EXPECT_EQ(treeOf(folder_.path()), before) << end;
  }
}

TEST_F(PatientRecords, AreNotImportedFromFoldersWithLinksOrNames)
{
  const fs::path exported = folder_ / "P-017";
  ASSERT_TRUE(exportPatient(file_, {}, exported));
  fs::create_symlink("/etc/passwd", exported / "insertions/one.insertion");
  EXPECT_FALSE(importPatient(exported, folder_ / "other", folder_ / "others"));
  fs::remove(exported / "insertions/one.insertion");
  std::ofstream(exported / "patient.toml") << "label = \"Doe, Jane\"\na_mm = 9.1\nb_mm = 6.7\n";
  EXPECT_FALSE(importPatient(exported, folder_ / "other", folder_ / "others"));
  EXPECT_TRUE(filesIn(folder_ / "other").empty());
  EXPECT_TRUE(filesIn(folder_ / "others").empty());
}

}  // namespace
}  // namespace perilymph::session
