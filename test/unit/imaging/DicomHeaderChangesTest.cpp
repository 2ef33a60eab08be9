// SPDX-License-Identifier: BSD-3-Clause

// Random changes of one header of a series, each read in a child process with little time and memory: none crashes,
// and none is accepted without a word unless the volume is the same.

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <random>

#include "StatedSeries.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

namespace fs = std::filesystem;

constexpr int same = 1, refused = 2, named = 3, silent = 4;

/// Positions of three decimals may change by their last one; half a percent of a voxel is no wrong measure.
constexpr double unseen_mm = 0.02;

bool areSame(const ct::CtVolume& a, const ct::CtVolume& b)
{
  if (a.size() != b.size()) return false;
  for (const double i : {0.0, 1.0})
    for (const double j : {0.0, 1.0})
      for (const double k : {0.0, 1.0}) {
        const Eigen::Vector3d corner(i * (a.size()[0] - 1), j * (a.size()[1] - 1),
                                     k * (a.size()[2] - 1));
        if (!((a.toLps(corner) - b.toLps(corner)).norm() < unseen_mm)) return false;
      }
  for (int k = 0; k < a.size()[2]; ++k)
    for (int j = 0; j < a.size()[1]; ++j)
      for (int i = 0; i < a.size()[0]; ++i)
        if (a.voxel(i, j, k) != b.voxel(i, j, k)) return false;
  return true;
}

/// Reads a folder in a child with 10 s of processor time and 1 GB of addresses.
int answerInChild(const fs::path& folder, const LoadedCt& original)
{
  const ::pid_t child = ::fork();
  if (child == 0) {
    const rlimit seconds = {10, 10};
    ::setrlimit(RLIMIT_CPU, &seconds);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const rlimit bytes = {1u << 30, 1u << 30};
    ::setrlimit(RLIMIT_AS, &bytes);  // a sanitizer needs more
#endif
    const auto loaded = readCt(folder);
    if (!loaded) ::_exit(refused);
    if (loaded->series.warnings.size() > original.series.warnings.size()) ::_exit(named);
    ::_exit(areSame(loaded->volume, original.volume) ? same : silent);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// Number of changed headers; a long run defines or states more.
int changes()
{
#ifdef HEADER_CHANGES
  constexpr int usual = HEADER_CHANGES;
#else
  constexpr int usual = 150;
#endif
  const char* const stated = std::getenv("PERILYMPH_HEADER_CHANGES");
  return stated ? std::atoi(stated) : usual;
}

/// One to four bytes of a header changed: any byte, a bit, or a digit by another.
void change(std::string& content, std::size_t headerBytes, std::mt19937& random)
{
  constexpr std::size_t preamble = 128;
  std::uniform_int_distribution<std::size_t> place(preamble, headerBytes - 1);
  const auto number = [&random](unsigned below) { return static_cast<unsigned>(random() % below); };
  for (unsigned left = 1 + number(4); left > 0; --left) {
    std::size_t at = place(random);
    const unsigned kind = number(3);
    if (kind == 0) content[at] = static_cast<char>(number(256));
    if (kind == 1) content[at] = static_cast<char>(content[at] ^ (1 << number(8)));
    if (kind == 2) {
      const std::size_t digit = content.find_first_of("0123456789", at);
      if (digit < headerBytes) at = digit;
      content[at] = static_cast<char>('0' + number(10));
    }
  }
}

TEST(ChangedDicomHeaders, NeitherCrashNorLie)
{
  const test::TemporaryFolder folder;
  const auto slices = statedSlices(smoothCt({20, 20, 6}));
  const fs::path series = folder / "series";
  test::writeDicomFiles(slices, series);
  const auto original = readCt(series);
  ASSERT_TRUE(original) << original.error().message;
  const std::string bytes = slices[2].file();
  const std::size_t headerBytes = bytes.size() - 2 * 20 * 20;
  fs::path file;
  for (const auto& entry : fs::directory_iterator(series)) {
    std::ifstream stream(entry.path(), std::ios::binary);
    if (std::string(std::istreambuf_iterator<char>(stream), {}) == bytes) file = entry.path();
  }
  ASSERT_FALSE(file.empty());
  std::map<int, int> answers;
  std::mt19937 random(11);
  for (int i = 0; i < changes(); ++i) {
    std::string changed = bytes;
    change(changed, headerBytes, random);
    std::ofstream(file, std::ios::binary | std::ios::trunc) << changed;
    const int answer = answerInChild(series, *original);
    ++answers[answer];
    if (answer == same || answer == refused || answer == named) continue;
    const fs::path kept = fs::temp_directory_path() / "perilymph-changed-header";
    if (std::getenv("PERILYMPH_KEEP_CHANGED")) std::ofstream(kept, std::ios::binary) << changed;
    std::string where;
    for (std::size_t at = 0; at < changed.size(); ++at)
      if (changed[at] != bytes[at])
        where += " " + std::to_string(at) + " in '" + bytes.substr(at < 12 ? 0 : at - 12, 24) + "'";
    ADD_FAILURE() << "change " << i << ": " << (answer == silent ? "silent" : "ended by") << " "
                  << answer << where;
  }
  for (const int answer : {same, refused, named}) EXPECT_GT(answers[answer], 0) << answer;
}

}  // namespace
}  // namespace perilymph::imaging
