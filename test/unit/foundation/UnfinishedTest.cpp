// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Unfinished.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <set>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

/// Does something in a process that is then killed. @return its number.
int inKilledProcess(const std::function<void()>& work)
{
  const pid_t child = fork();
  if (child == 0) {
    work();
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  return child;
}

std::set<std::string> namesIn(const fs::path& folder)
{
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

void touch(const fs::path& file) { std::ofstream(file) << "content"; }

class Unfinished : public testing::Test {
protected:
  const test::TemporaryFolder folder_;
};

TEST_F(Unfinished, PathsOfOneTargetDiffer)
{
  std::set<fs::path> paths;
  for (int i = 0; i < 100; ++i) paths.insert(unfinishedPath(folder_ / "a.csv"));
  EXPECT_EQ(paths.size(), 100u);
  for (const fs::path& each : paths) {
    EXPECT_EQ(each.parent_path(), folder_.path());
    EXPECT_EQ(each.extension(), ".csv");
  }
}

TEST_F(Unfinished, FilesOfKilledProcessesAreRemoved)
{
  inKilledProcess([this] {
    for (const char* name : {"a.csv", "study.sqlite", "no extension", ".hidden.toml", "a.b.c.png"})
      touch(unfinishedPath(folder_ / name));
    for (const char* ending : {"-wal", "-shm", "-journal"})
      touch(unfinishedPath(folder_ / "study.sqlite").string() + ending);
    // of a file that is itself unfinished
    touch(unfinishedPath(unfinishedPath(folder_ / "study.sqlite")));
    const fs::path made = unfinishedPath(folder_ / "P-017");
    fs::create_directories(made / "insertions");
    touch(made / "insertions/a.insertion");
  });
  EXPECT_EQ(namesIn(folder_.path()).size(), 10u);
  removeLeftovers(folder_.path());
  EXPECT_THAT(namesIn(folder_.path()), IsEmpty());
}

TEST_F(Unfinished, FilesOfOthersStay)
{
  touch(unfinishedPath(folder_ / "mine.csv"));
  const int dead = inKilledProcess([] {});
  const std::string process = std::to_string(dead);
  for (const std::string& name :
       {".a.another-machine-" + process + ".0.part.csv", "a." + process + ".part.csv",
        ".a." + process + ".part.csv", std::string("P-017.part"), std::string(".a.part.csv"),
        std::string(".part"), "thesis.begin-" + process, ".a." + process + ".0.part.csv",
        "a-" + process + ".0.part.csv"})
    touch(folder_ / name);
  const auto before = namesIn(folder_.path());
  removeLeftovers(folder_.path());
  EXPECT_EQ(namesIn(folder_.path()), before);
}

TEST_F(Unfinished, LinksStayAndAreNotFollowed)
{
  fs::create_directory(folder_ / "own");
  touch(folder_ / "own/thesis");
  inKilledProcess([this] {
    fs::create_symlink(folder_ / "own", unfinishedPath(folder_ / "a"));
    fs::create_symlink(folder_ / "own/thesis", unfinishedPath(folder_ / "b"));
    const fs::path made = unfinishedPath(folder_ / "c");
    fs::create_directory(made);
    fs::create_symlink(folder_ / "own", made / "link");
  });
  removeLeftovers(folder_.path());
  EXPECT_TRUE(fs::exists(folder_ / "own/thesis"));
  EXPECT_EQ(namesIn(folder_.path()).size(), 3u);  // "own" and the two links
}

TEST_F(Unfinished, FilesOfOlderProgramsAreRemovedAnHourLater)
{
  const std::string process = std::to_string(inKilledProcess([] {}));
  for (const std::string& name :
       {".a." + process + ".0.part.csv", "study.sqlite.unfinished.begin-" + process,
        "study.sqlite.unfinished.begin-" + process + "-journal"}) {
    touch(folder_ / name);
    removeLeftovers(folder_.path());
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
    fs::last_write_time(folder_ / name, fs::file_time_type::clock::now() - 2h);
    removeLeftovers(folder_.path());
    EXPECT_FALSE(fs::exists(folder_ / name)) << name;
  }
}

TEST_F(Unfinished, FoldersWithNamesOfOlderProgramsStay)
{
  const std::string process = std::to_string(inKilledProcess([] {}));
  const fs::path folder = folder_ / ("thesis.begin-" + process);
  fs::create_directory(folder);
  fs::last_write_time(folder, fs::file_time_type::clock::now() - 2h);
  removeLeftovers(folder_.path());
  EXPECT_TRUE(fs::exists(folder));
}

TEST_F(Unfinished, FoldersAreForTheirOwnerAndAppearWhole)
{
  {
    auto made = UnfinishedFolder::create(folder_ / "P-017");
    ASSERT_TRUE(made) << made.error().message;
    struct stat status = {};
    ASSERT_EQ(stat(made->path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0700u);
    touch(made->path() / "a");
    ASSERT_TRUE(made->finish());
  }
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("P-017"));
  EXPECT_TRUE(fs::exists(folder_ / "P-017/a"));
}

TEST_F(Unfinished, FoldersReplaceNothing)
{
  fs::create_directory(folder_ / "empty");
  fs::create_symlink("nowhere", folder_ / "link");
  touch(folder_ / "file");
  for (const char* name : {"empty", "link", "file"}) {
    auto made = UnfinishedFolder::create(folder_ / name);
    ASSERT_TRUE(made);
    EXPECT_FALSE(made->finish()) << name;
  }
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("empty", "file", "link"));
  EXPECT_TRUE(fs::is_empty(folder_ / "empty"));
}

}  // namespace
}  // namespace perilymph
