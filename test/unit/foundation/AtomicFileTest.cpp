// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/AtomicFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void put(const fs::path& file, const std::string& content) { std::ofstream(file) << content; }

std::string contentOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t filesIn(const fs::path& folder)
{
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

std::string messageOf(const Result<void>& result)
{
  return result ? "no error" : result.error().message;
}

std::string messageOf(const Result<std::string>& result)
{
  return result ? "no error" : result.error().message;
}

TEST(WriteWhole, PutsEveryByteInPlaceAndNothingBeside)
{
  const test::TemporaryFolder folder;
  const std::string content("a\0b\r\n\xff", 6);
  ASSERT_TRUE(writeWhole(folder / "out.bin", content));
  EXPECT_EQ(contentOf(folder / "out.bin"), content);
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WriteWhole, ReplacesAnOlderFileAndKeepsItsPermissions)
{
  const test::TemporaryFolder folder;
  put(folder / "out.csv", "older and longer");
  ASSERT_EQ(::chmod((folder / "out.csv").c_str(), 0640), 0);
  ASSERT_TRUE(writeWhole(folder / "out.csv", std::string_view("new")));
  EXPECT_EQ(contentOf(folder / "out.csv"), "new");
  EXPECT_EQ(fs::status(folder / "out.csv").permissions(), fs::perms(0640));
}

TEST(WriteWhole, ShowsTheOlderFileUntilTheNewOneIsWhole)
{
  const test::TemporaryFolder folder;
  put(folder / "out.vtp", "older");
  fs::path neighbor;
  ASSERT_TRUE(writeWhole(folder / "out.vtp", [&](const fs::path& path) {
    neighbor = path;
    put(path, "new");
    return contentOf(folder / "out.vtp") == "older";
  }));
  EXPECT_EQ(neighbor.extension(), ".vtp");
  EXPECT_EQ(neighbor.parent_path(), folder.path());
  EXPECT_EQ(contentOf(folder / "out.vtp"), "new");
}

TEST(WriteWhole, LeavesTheOlderFileAndNothingElseWhenTheWriterFails)
{
  const test::TemporaryFolder folder;
  put(folder / "out.png", "older");
  const auto failing = [](const fs::path& path) {
    put(path, "half");
    return false;
  };
  EXPECT_THAT(messageOf(writeWhole(folder / "out.png", failing)),
              HasSubstr("Cannot write " + (folder / "out.png").string() + ": "));
  EXPECT_EQ(contentOf(folder / "out.png"), "older");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WriteWhole, TellsTheWordsOfAWriterThatThrows)
{
  const test::TemporaryFolder folder;
  const auto throwing = [](const fs::path& path) -> bool {
    put(path, "half");
    throw std::runtime_error("no picture to write");
  };
  EXPECT_THAT(messageOf(writeWhole(folder / "out.png", throwing)),
              HasSubstr("no picture to write"));
  EXPECT_EQ(filesIn(folder.path()), 0u);
}

TEST(WriteWhole, FollowsASymbolicLink)
{
  const test::TemporaryFolder folder;
  put(folder / "real.txt", "older");
  fs::create_symlink("real.txt", folder / "link.txt");
  ASSERT_TRUE(writeWhole(folder / "link.txt", std::string_view("new")));
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(contentOf(folder / "real.txt"), "new");
}

TEST(WriteWhole, FollowsASymbolicLinkToAFileThatIsNotThereYet)
{
  const test::TemporaryFolder folder;
  fs::create_symlink("later.txt", folder / "link.txt");
  ASSERT_TRUE(writeWhole(folder / "link.txt", std::string_view("new")));
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(contentOf(folder / "later.txt"), "new");
}

TEST(WriteWhole, RefusesALinkInAFolderThatAProgramFills)
{
  const test::TemporaryFolder folder;
  put(folder / "thesis", "of the user");
  fs::create_symlink(folder / "thesis", folder / "link.csv");
  fs::create_symlink(folder / "nothing", folder / "dangling.csv");
  fs::create_symlink("/dev/null", folder / "device.csv");
  fs::create_directory(folder / "elsewhere");
  fs::create_directory_symlink(folder / "elsewhere", folder / "folder.csv");
  const Writing inFolder{Links::refused};
  for (const char* name : {"link.csv", "dangling.csv", "device.csv", "folder.csv"}) {
    EXPECT_THAT(messageOf(checkWritable(folder / name, Links::refused)), HasSubstr("is a link"));
    EXPECT_THAT(messageOf(writeWhole(folder / name, std::string_view("new"), inFolder)),
                HasSubstr("is a link"));
    const auto write = [](const fs::path& place) {
      put(place, "new");
      return true;
    };
    EXPECT_THAT(messageOf(writeWhole(folder / name, write, inFolder)), HasSubstr("is a link"));
    EXPECT_TRUE(fs::is_symlink(folder / name));
  }
  EXPECT_EQ(contentOf(folder / "thesis"), "of the user");
  EXPECT_FALSE(fs::exists(folder / "nothing"));
  EXPECT_EQ(filesIn(folder.path()), 6u);
  EXPECT_EQ(filesIn(folder / "elsewhere"), 0u);
}

TEST(WriteWhole, ReplacesNothingIfItMustBeNew)
{
  const test::TemporaryFolder folder;
  const Writing once{Links::refused, Audience::everyone, Existing::refused};
  ASSERT_TRUE(writeWhole(folder / "a", std::string_view("first"), once));
  EXPECT_FALSE(writeWhole(folder / "a", std::string_view("second"), once));
  EXPECT_EQ(contentOf(folder / "a"), "first");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WriteWhole, KeepsWhatNamesAPatientForItsOwner)
{
  const test::TemporaryFolder folder;
  const auto before = ::umask(0);
  put(folder / "older", "readable");
  const Writing own{Links::followed, Audience::owner};
  for (const char* name : {"older", "new"}) {
    ASSERT_TRUE(writeWhole(folder / name, std::string_view("name"), own));
    EXPECT_EQ(fs::status(folder / name).permissions(), fs::perms(0600)) << name;
  }
  ::umask(before);
}

TEST(WriteWhole, NeverReplacesAReadOnlyFile)
{
  const test::TemporaryFolder folder;
  put(folder / "old.csv", "kept");
  ::chmod((folder / "old.csv").c_str(), 0444);  // applies to root, too
  EXPECT_THAT(messageOf(checkWritable(folder / "old.csv")), HasSubstr("read-only"));
  EXPECT_THAT(messageOf(writeWhole(folder / "old.csv", std::string_view("new"))),
              HasSubstr("read-only"));
  EXPECT_EQ(contentOf(folder / "old.csv"), "kept");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(CheckWritable, AnswersAsWritingWould)
{
  const test::TemporaryFolder folder;
  EXPECT_TRUE(checkWritable(folder / "new.csv"));
  EXPECT_TRUE(checkWritable("/dev/null"));
  EXPECT_THAT(messageOf(checkWritable(folder.path())), HasSubstr("it is a folder"));
  EXPECT_THAT(messageOf(checkWritable(folder / "no" / "new.csv")), HasSubstr("does not exist"));
  EXPECT_EQ(filesIn(folder.path()), 0u);
}

TEST(UnfinishedFiles, AreRemovedBeforeASignalEndsTheProcess)
{
  const test::TemporaryFolder folder;
  put(folder / "old.csv", "older");
  std::size_t during = 0, after = 0;
  EXPECT_FALSE(writeWhole(folder / "old.csv", [&](const fs::path& path) {
    put(path, "half");
    during = filesIn(folder.path());
    removeUnfinishedFiles();
    after = filesIn(folder.path());
    return true;
  }));
  EXPECT_EQ(during, 2u);
  EXPECT_EQ(after, 1u);
  removeUnfinishedFiles();  // nothing is being written now
  EXPECT_EQ(contentOf(folder / "old.csv"), "older");
}

TEST(WriteWhole, TakesTheLongestFileNameThereIs)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder / (std::string(251, 'n') + ".csv");
  EXPECT_TRUE(writeWhole(file, std::string_view("x")));
  EXPECT_EQ(contentOf(file), "x");
}

TEST(WriteWhole, SaysThatTheFolderIsMissing)
{
  const test::TemporaryFolder folder;
  EXPECT_THAT(
      messageOf(writeWhole(folder / "no" / "out.csv", std::string_view("x"))),
      HasSubstr("the folder " + (folder / "no").string() + " does not exist. Create it first."));
}

TEST(WriteWhole, SaysThatThePlaceIsAFolder)
{
  const test::TemporaryFolder folder;
  EXPECT_THAT(messageOf(writeWhole(folder.path(), std::string_view("x"))),
              HasSubstr("it is a folder. Give the name of a file in it."));
}

TEST(WriteWhole, SaysThatNoFileIsNamed)
{
  EXPECT_THAT(messageOf(writeWhole("", std::string_view("x"))), HasSubstr("names no file"));
}

TEST(WriteWhole, SaysThatTheFolderMayNotBeWritten)
{
  if (::geteuid() == 0) GTEST_SKIP() << "The superuser may write everywhere.";
  const test::TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const std::string message = messageOf(writeWhole(folder / "out.csv", std::string_view("x")));
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_THAT(message, HasSubstr("Permission denied"));
}

TEST(WriteWhole, SaysThatTheDiskIsFull)
{
  EXPECT_THAT(messageOf(writeWhole("/dev/full", std::string_view("x"))),
              HasSubstr("No space left on device"));
}

TEST(WriteWhole, WritesIntoADeviceWithoutReplacingIt)
{
  EXPECT_TRUE(writeWhole("/dev/null", std::string_view("x")));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteWhole, LetsOneOfTwoWritersWinWhole)
{
  const test::TemporaryFolder folder;
  const std::string a(100000, 'a');
  const std::string b(200000, 'b');
  const auto writeOften = [&](const std::string& content) {
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(writeWhole(folder / "out.txt", content));
  };
  std::thread other([&] { writeOften(a); });
  writeOften(b);
  other.join();
  const std::string last = contentOf(folder / "out.txt");
  EXPECT_TRUE(last == a || last == b);
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(ReadWhole, GivesEveryByte)
{
  const test::TemporaryFolder folder;
  put(folder / "in.txt", "one\ntwo");
  put(folder / "empty.txt", "");
  EXPECT_EQ(*readWhole(folder / "in.txt"), "one\ntwo");
  EXPECT_EQ(*readWhole(folder / "empty.txt"), "");
}

TEST(ReadWhole, SaysThatThereIsNoSuchFile)
{
  const test::TemporaryFolder folder;
  EXPECT_EQ(
      messageOf(readWhole(folder / "no.toml")),
      "Cannot read " + (folder / "no.toml").string() + ": there is no such file. Check the path.");
}

TEST(ReadWhole, WaitsForNobodyAtAPipe)
{
  const test::TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(messageOf(readWhole(folder / "pipe")), HasSubstr("it is a pipe or a device"));
  fs::create_symlink("pipe", folder / "link");
  EXPECT_THAT(messageOf(readWhole(folder / "link")), HasSubstr("it is a pipe or a device"));
}

TEST(ReadWhole, RefusesDevices)
{
  for (const char* device : {"/dev/zero", "/dev/full", "/dev/null", "/dev/tty"})
    EXPECT_THAT(messageOf(readWhole(device)), HasSubstr(std::string("Cannot read ") + device));
}

TEST(ReadWhole, TakesAsManyBytesAsItIsTold)
{
  const test::TemporaryFolder folder;
  put(folder / "in.txt", std::string(std::size_t{1} << 20, 'x'));
  EXPECT_TRUE(readWhole(folder / "in.txt", std::size_t{1} << 20));
  put(folder / "in.txt", std::string((std::size_t{1} << 20) + 1, 'x'));
  EXPECT_THAT(messageOf(readWhole(folder / "in.txt", std::size_t{1} << 20)),
              HasSubstr("larger than 1 MiB"));
  // Files in /proc report size 0 although they have content.
  EXPECT_TRUE(readWhole("/proc/self/status"));
}

TEST(ReadWhole, SaysThatItIsAFolder)
{
  const test::TemporaryFolder folder;
  EXPECT_THAT(messageOf(readWhole(folder.path())), HasSubstr("it is a folder"));
}

TEST(ReadWhole, SaysThatTheFileMayNotBeRead)
{
  if (::geteuid() == 0) GTEST_SKIP() << "The superuser may read everything.";
  const test::TemporaryFolder folder;
  put(folder / "in.txt", "x");
  fs::permissions(folder / "in.txt", fs::perms::none);
  EXPECT_THAT(messageOf(readWhole(folder / "in.txt")), HasSubstr("Permission denied"));
}

TEST(ReadWhole, TakesUpTo16MiBAndNoByteMore)
{
  const test::TemporaryFolder folder;
  put(folder / "large.txt", "");
  fs::resize_file(folder / "large.txt", std::uintmax_t{16} << 20);
  EXPECT_TRUE(readWhole(folder / "large.txt"));
  fs::resize_file(folder / "large.txt", (std::uintmax_t{16} << 20) + 1);
  EXPECT_THAT(messageOf(readWhole(folder / "large.txt")), HasSubstr("larger than 16 MiB"));
}

}  // namespace
}  // namespace perilymph
