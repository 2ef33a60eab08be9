// SPDX-License-Identifier: BSD-3-Clause

// A patient as a folder that travels to another workstation.

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
#include <stop_token>

#include "PatientRecordRig.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::session {
namespace {

using testing::HasSubstr;

TEST_F(PatientRecords, TravelAsAFolderWithTheInsertions)
{
  ASSERT_TRUE(savePatientRecord(record_, file_));
  record(folder_ / "recordings/one.insertion");
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
  EXPECT_EQ(*readWhole(folder_ / "others/one.insertion"),
            *readWhole(folder_ / "recordings/one.insertion"));
}

TEST_F(PatientRecords, ReplaceNothingWhenTheyTravel)
{
  const fs::path exported = folder_ / "P-017";
  record(folder_ / "recordings/one.insertion");
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
    record(recordings.back());
  }
  const std::uintmax_t size = fs::file_size(recordings.front());
  ASSERT_TRUE(exportPatient(file_, recordings, folder_ / "whole"));
  const auto before = treeOf(folder_.path());
  for (const std::uintmax_t end : {std::uintmax_t{0}, std::uintmax_t{1}, size + 1}) {
    std::uintmax_t last = 0;
    std::stop_source stop;
    const CopyProgress progress = [&](std::uintmax_t done, std::uintmax_t all) {
      EXPECT_GE(done, last);
      EXPECT_EQ(all, 3 * size);
      last = done;
      if (done >= end) stop.request_stop();
    };
    const auto exported =
        exportPatient(file_, recordings, folder_ / "P-017", progress, stop.get_token());
    ASSERT_FALSE(exported);
    EXPECT_THAT(exported.error().message, HasSubstr("canceled"));
    last = 0;
    stop = std::stop_source();
    const auto imported = importPatient(folder_ / "whole", folder_ / "other", folder_ / "others",
                                        progress, stop.get_token());
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

TEST_F(PatientRecords, WithoutTheirPatientAreNotReplacedByAnImport)
{
  const fs::path exported = folder_ / "P-017";
  ASSERT_TRUE(savePatientRecord(record_, file_));
  ASSERT_TRUE(exportPatient(file_, {}, exported));
  fs::remove(file_);
  const auto imported = importPatient(exported, folder_ / "patients", folder_ / "others");
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().message, HasSubstr("holds notes on a patient of this code"));
  EXPECT_EQ(*loadPatientRecord(file_), record_);
}

TEST_F(PatientRecords, AreNotImportedWithWhatIsNoRecording)
{
  const fs::path exported = folder_ / "P-017";
  ASSERT_TRUE(exportPatient(file_, {}, exported));
  std::ofstream(exported / "insertions/one.insertion") << "no recording";
  const auto imported = importPatient(exported, folder_ / "other", folder_ / "others");
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().message, HasSubstr("cannot be imported"));
  EXPECT_TRUE(filesIn(folder_ / "other").empty());
  EXPECT_TRUE(filesIn(folder_ / "others").empty());
}

TEST_F(PatientRecords, AreImportedByOneOfTwoPrograms)
{
  const fs::path exported = folder_ / "P-017";
  ASSERT_TRUE(exportPatient(file_, {}, exported));
  const int programs = 4;
  for (int i = 0; i < programs; ++i)
    if (::fork() == 0) {
      const bool isDone(importPatient(exported, folder_ / "other", folder_ / "others"));
      ::_exit(isDone ? 0 : 1);
    }
  int done = 0;
  for (int i = 0; i < programs; ++i) {
    int status = 0;
    ::wait(&status);
    done += status == 0 ? 1 : 0;
  }
  EXPECT_EQ(done, 1);
  EXPECT_EQ(filesIn(folder_ / "other").size(), 2u);
}

}  // namespace
}  // namespace perilymph::session
