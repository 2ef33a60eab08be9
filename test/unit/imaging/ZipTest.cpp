// SPDX-License-Identifier: BSD-3-Clause

// Archives as portals send them, and those that no portal sends.

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zip.h>

#include <fstream>
#include <random>

#include "StatedSeries.h"
#include "perilymph/imaging/CtSeries.h"

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

using Entries = std::vector<std::pair<std::string, std::string>>;  // names and contents

class Zip : public testing::Test {
protected:
  void SetUp() override
  {
    for (std::size_t k = 0; k < slices.size(); ++k)
      entries.emplace_back("DICOM/Müller/IM" + std::to_string(k) + ".dcm", slices[k].file());
  }

  fs::path pack(const Entries& contents, const char* password = nullptr)
  {
    const fs::path file = folder / (std::to_string(++count) + ".zip");
    zip_t* const archive = zip_open(file.c_str(), ZIP_CREATE, nullptr);
    for (const auto& [name, content] : contents) {
      zip_source_t* const source = zip_source_buffer(archive, content.data(), content.size(), 0);
      const auto index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
      if (index < 0) throw std::runtime_error(zip_strerror(archive));
      if (password != nullptr)
        zip_file_set_encryption(archive, static_cast<zip_uint64_t>(index), ZIP_EM_AES_256,
                                password);
    }
    if (zip_close(archive) != 0) throw std::runtime_error(zip_strerror(archive));
    return file;
  }

  void expectRefusal(const fs::path& file, const std::string& says)
  {
    const auto loaded = readCt(file);
    ASSERT_FALSE(loaded) << says;
    EXPECT_THAT(loaded.error().message, HasSubstr(says));
    EXPECT_THAT(loaded.error().message, testing::StartsWith(file.string()));
    EXPECT_EQ(leftBehind(), 0);
  }

  /// Folders that reading leaves for temporary files.
  int leftBehind() const
  {
    int folders = 0;
    for (const auto& entry : fs::directory_iterator(temporary))
      folders += entry.path().filename().string().starts_with(".perilymph-zip.") ? 1 : 0;
    return folders;
  }

  const ct::CtVolume volume = smoothCt();
  const std::vector<test::DicomData> slices = statedSlices(volume);
  Entries entries;
  test::TemporaryFolder folder;
  test::TemporaryFolder elsewhere;
  const fs::path temporary = [this] {
    ::setenv("TMPDIR", elsewhere.path().c_str(), 1);
    return elsewhere.path();
  }();
  int count = 0;

  void TearDown() override { ::unsetenv("TMPDIR"); }
};

TEST_F(Zip, IsReadAsItCame)
{
  {
    const auto list = findSeries(pack(entries));
    ASSERT_TRUE(list) << list.error().message;
    ASSERT_EQ(list->series.size(), 1u);
    EXPECT_EQ(leftBehind(), 1);
    const auto status = fs::status(fs::directory_iterator(temporary)->path());
    EXPECT_EQ(status.permissions(), fs::perms::owner_all);
    const auto loaded = readCt(*list, "1.2.3.4");
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->volume.size(), volume.size());
    EXPECT_EQ(loaded->volume.voxel(10, 10, 5), volume.voxel(10, 10, 5));
    EXPECT_EQ(loaded->series.warnings.size(), 1u);
  }
  EXPECT_EQ(leftBehind(), 0);
  const auto loaded = readCt(pack(entries));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->volume.voxel(10, 10, 5), volume.voxel(10, 10, 5));
  EXPECT_EQ(leftBehind(), 0);
}

TEST_F(Zip, RemovesWhatAKilledProgramLeft)
{
  const fs::path archive = pack(entries);
  const pid_t other = ::fork();
  if (other == 0) {
    const auto list = findSeries(archive);
    ::_exit(list && leftBehind() == 1 ? 0 : 1);  // without its destructors, as by a signal
  }
  int status = -1;
  ASSERT_EQ(::waitpid(other, &status, 0), other);
  ASSERT_EQ(status, 0);
  EXPECT_EQ(leftBehind(), 1);
  ASSERT_TRUE(findSeries(archive));
  EXPECT_EQ(leftBehind(), 0);
}

TEST_F(Zip, KeepsItsFolderWhileItIsRead)
{
  const auto list = findSeries(pack(entries));
  ASSERT_TRUE(list) << list.error().message;
  for (const auto& entry : fs::directory_iterator(temporary))
    fs::last_write_time(entry, fs::file_time_type::clock::now() - std::chrono::hours(1));
  ASSERT_TRUE(findSeries(pack(entries)));
  const auto loaded = readCt(*list, "1.2.3.4");
  EXPECT_TRUE(loaded) << loaded.error().message;
}

TEST_F(Zip, WritesNothingOutsideOfItsFolder)
{
  Entries hostile;
  const char* const names[] = {"../../evil",   "/tmp/../evil", "..\\..\\evil",
                               "a/../../evil", "..",           "."};
  for (std::size_t k = 0; k < slices.size(); ++k)
    hostile.emplace_back(
        k < std::size(names) ? names[k] : std::string(300, 'x') + std::to_string(k),
        slices[k].file());
  const auto loaded = readCt(pack(hostile));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->volume.size()[2], 10);
  EXPECT_FALSE(fs::exists(temporary / "evil"));
  EXPECT_FALSE(fs::exists(temporary.parent_path() / "evil"));
  EXPECT_EQ(leftBehind(), 0);
}

TEST_F(Zip, ThatIsEncryptedIsRefused) { expectRefusal(pack(entries, "secret"), "is encrypted"); }

TEST_F(Zip, WithoutAnImageIsRefused)
{
  expectRefusal(pack({{"letter.txt", "Dear colleague"}}), "holds no DICOM image");
  // an archive in the archive stays packed
  std::ifstream inner(pack(entries), std::ios::binary);
  const std::string packed(std::istreambuf_iterator<char>(inner), {});
  expectRefusal(pack({{"inner.zip", packed}}), "holds no DICOM image");
}

TEST_F(Zip, ThatUnpacksToTooMuchIsRefused)
{
  const std::string zeros(std::size_t{80} << 20, '\0');
  expectRefusal(pack({{"zeros", zeros}}), "more than a hundred times its size");
  Entries many;
  for (std::size_t i = 0; i <= maxCtFiles; ++i) many.emplace_back(std::to_string(i), "");
  expectRefusal(pack(many), "more than 20000 files");
}

TEST_F(Zip, ThatIsDamagedIsRefusedOrGivesTheSameVolume)
{
  std::ifstream stream(pack(entries), std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(stream), {});
  std::mt19937 random(9);
  const fs::path file = folder / "damaged.zip";
  for (int i = 0; i < 60; ++i) {
    std::string damaged = whole;
    if (i % 3 == 0)
      damaged.resize(4 + random() % (whole.size() - 4));
    else
      for (int k = 0; k < 3; ++k)
        damaged[4 + random() % (whole.size() - 4)] = static_cast<char>(random());
    std::ofstream(file, std::ios::binary | std::ios::trunc) << damaged;
    const auto loaded = readCt(file);
    if (!loaded) {
      EXPECT_THAT(loaded.error().message, testing::EndsWith("."));
      continue;
    }
    ASSERT_EQ(loaded->volume.size(), volume.size()) << i;
    EXPECT_EQ(loaded->volume.voxel(10, 10, 5), volume.voxel(10, 10, 5)) << i;
  }
  EXPECT_EQ(leftBehind(), 0);
}

TEST_F(Zip, ThatCannotBeUnpackedSaysWhere)
{
  const fs::path file = pack(entries);
  ::setenv("TMPDIR", (folder / "nowhere").c_str(), 1);
  const auto loaded = readCt(file);
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, HasSubstr("(TMPDIR) is missing, full"));
}

}  // namespace
}  // namespace perilymph::imaging
