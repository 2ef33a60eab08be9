// SPDX-License-Identifier: BSD-3-Clause

// Small packed files whose headers claim gigabytes.

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "SmallVolumeFiles.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

using testing::HasSubstr;

/// Writes a header and `bytes` bytes of zero, gzipped in pieces of 4 MB, as pigz does.
void writeConstant(const std::filesystem::path& file, const std::string& header, std::size_t bytes,
                   const std::string& before = "")
{
  std::ofstream out(file, std::ios::binary);
  out << before << gzipped(header);
  const std::string zeros(std::size_t{1} << 22, '\0'), packed = gzipped(zeros);
  for (; bytes >= zeros.size(); bytes -= zeros.size()) out << packed;
  out << gzipped(zeros.substr(0, bytes));
}

/// A NIfTI header of a cube of voxels.
std::string niftiCube(int edge, std::int16_t datatype, std::int16_t bits)
{
  Bytes bytes = niftiFile(obliqueCt(), Form::sform);
  for (std::size_t axis = 0; axis < 3; ++axis)
    bytes.put<std::int16_t>(42 + 2 * axis, static_cast<std::int16_t>(edge));
  bytes.put<std::int16_t>(70, datatype);
  bytes.put<std::int16_t>(72, bits);
  return bytes.content.substr(0, firstVoxel);
}

/// The error of reading a file in a child that may have so many bytes more than its parent and half
/// a minute of processor time; "(read)" without an error, "(ended)" if it ends otherwise.
std::string errorWithin(std::size_t moreBytes, const std::filesystem::path& file)
{
  int ends[2] = {};
  if (::pipe(ends) != 0) return "(no pipe)";
  const ::pid_t child = ::fork();
  if (child == 0) {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t limit = pages * static_cast<std::size_t>(::getpagesize()) + moreBytes;
    const rlimit bytes = {limit, limit}, seconds = {30, 30};
    ::setrlimit(RLIMIT_CPU, &seconds);
    ::setrlimit(RLIMIT_AS, &bytes);
    const auto loaded = readCt(file);
    const std::string answer = loaded ? "(read)" : loaded.error().message;
    const auto written = ::write(ends[1], answer.data(), answer.size());
    ::_exit(written < 0 ? 1 : 0);
  }
  ::close(ends[1]);
  std::string answer;
  char part[512];
  for (::ssize_t count = 0; (count = ::read(ends[0], part, sizeof part)) > 0;)
    answer.append(part, static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return answer.empty() ? "(ended)" : answer;
}

class PackedVolumes : public testing::Test {
protected:
  test::TemporaryFolder folder_;
};

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// A sanitizer's own memory hides what the program takes.
constexpr std::size_t fewBytes = std::size_t{96} << 20;

TEST_F(PackedVolumes, WithoutContrastAreRefusedBeforeTheyTakeMemory)
{
  // 432 MB of doubles would be 108 MB of voxels, 460 MB of 16 bits as many
  writeConstant(folder_ / "doubles.nii.gz", niftiCube(380, 64, 64),
                std::size_t{380} * 380 * 380 * 8);
  writeConstant(folder_ / "words.nii.gz", niftiCube(620, 4, 16), std::size_t{620} * 620 * 620 * 2);
  std::string header = nrrdHeader("short", "gzip", "LPS", 1.0);
  writeConstant(folder_ / "words.nrrd", "", std::size_t{620} * 620 * 620 * 2,
                replaced(header, "12 10 8", "620 620 620"));
  for (const char* name : {"doubles.nii.gz", "words.nii.gz", "words.nrrd"})
    EXPECT_THAT(errorWithin(fewBytes, folder_ / name), HasSubstr("span less than 100")) << name;
}

TEST_F(PackedVolumes, ThatAreTooSmallForWhatTheyClaimAreRefusedAtOnce)
{
  std::ofstream(folder_ / "a.nii.gz", std::ios::binary)
      << gzipped(niftiCube(1000, 64, 64) + obliqueVoxels());
  std::ofstream(folder_ / "a.mha", std::ios::binary)
      << replaced(metaHeader("CompressedData = True\n"), "12 10 8", "1000 1000 1000") +
             zipped(obliqueVoxels());
  std::ofstream(folder_ / "a.nrrd", std::ios::binary)
      << replaced(nrrdHeader("short", "gzip", "LPS", 1.0), "12 10 8", "1000 1000 1000") +
             gzipped(obliqueVoxels());
  for (const char* name : {"a.nii.gz", "a.mha", "a.nrrd"})
    EXPECT_THAT(errorWithin(fewBytes, folder_ / name),
                testing::AllOf(HasSubstr("the length of its voxels"), HasSubstr("at most")))
        << name;
}

TEST_F(PackedVolumes, ThatInflateToMoreThanTheyClaimAreRefusedAfterThat)
{
  Bytes bytes = niftiFile(obliqueCt(), Form::sform);
  writeConstant(folder_ / "a.nii.gz", bytes.content, std::size_t{3} << 30);
  EXPECT_THAT(errorWithin(fewBytes, folder_ / "a.nii.gz"),
              HasSubstr("1920 bytes in its sizes and number type and more than 4196224 bytes"));
}
#endif

TEST_F(PackedVolumes, MayBeSeveralStreamsBehindEachOther)
{
  const std::string content = niftiFile(obliqueCt(), Form::sform).content;
  std::ofstream(folder_ / "a.nii.gz", std::ios::binary)
      << gzipped(content.substr(0, 1000)) + gzipped(content.substr(1000));
  EXPECT_TRUE(readCt(folder_ / "a.nii.gz"));
  std::ofstream(folder_ / "b.nii.gz", std::ios::binary) << gzipped(content) + "more";
  const auto loaded = readCt(folder_ / "b.nii.gz");
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, HasSubstr("cut off or damaged"));
}

TEST_F(PackedVolumes, WithADamagedByteAreRefused)
{
  const std::string packed = gzipped(niftiFile(obliqueCt(), Form::sform).content);
  for (std::size_t at = 20; at < packed.size(); at += 7) {
    std::string damaged = packed;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    std::ofstream(folder_ / "a.nii.gz", std::ios::binary) << damaged;
    EXPECT_FALSE(readCt(folder_ / "a.nii.gz")) << at;
  }
}

}  // namespace
}  // namespace perilymph::imaging
