// SPDX-License-Identifier: BSD-3-Clause

// Random changes of volume files' headers, each read in a child process with little time and memory:
// none crashes, and none whose statements differ is read without a word. In a third of the files the
// voxels are cut short as well, before or after they are packed. A parser of the test's own
// judges, which knows the formats from their documents. HEADER_CHANGES of each format are made.

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include "SmallVolumeFiles.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

namespace fs = std::filesystem;

using Random = std::mt19937;

/// What a file's header says of its voxels, by all its statements.
struct Stated {
  std::vector<Eigen::Vector3d> sizes_mm;  ///< Voxel sizes, as often as they are stated.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  double headerBytes = 0.0, dataBytes = 0.0;
  double unit_mm = 1.0;
};

template <class Value>
Value valueAt(const std::string& bytes, std::size_t at)
{
  Value value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

Stated statedByNifti(const std::string& bytes)
{
  Stated stated;
  const double units_mm[] = {1.0, 1000.0, 1.0, 0.001};
  stated.unit_mm = units_mm[bytes[123] & 3];
  Eigen::Vector3d pixdim, columns;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    pixdim[a] = std::fabs(static_cast<double>(valueAt<float>(bytes, 80 + 4 * axis)));
    for (std::size_t row = 0; row < 3; ++row)
      stated.axes(static_cast<Eigen::Index>(row), a) =
          static_cast<double>(valueAt<float>(bytes, 280 + 16 * row + 4 * axis));
    columns[a] = stated.axes.col(a).norm();
  }
  stated.sizes_mm.push_back(stated.unit_mm * pixdim);
  const auto sform = valueAt<std::int16_t>(bytes, 254), qform = valueAt<std::int16_t>(bytes, 252);
  const bool isUsed = sform > 0 && stated.axes.allFinite() && !stated.axes.isZero(0.0) &&
                      !(sform > 2 && qform > 0 && qform <= 2);
  if (isUsed)
    stated.sizes_mm.push_back(stated.unit_mm * columns);
  else
    stated.axes = Eigen::Matrix3d::Identity();
  stated.headerBytes = static_cast<double>(valueAt<float>(bytes, 108));
  stated.dataBytes = valueAt<std::int16_t>(bytes, 72) / 8.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    stated.dataBytes *= valueAt<std::int16_t>(bytes, 42 + 2 * axis);
  return stated;
}

/// Whether a line begins with a name, in letters of any case as the formats allow.
bool begins(const std::string& line, const std::string& name)
{
  return line.size() >= name.size() &&
         std::equal(name.begin(), name.end(), line.begin(), [](unsigned char a, unsigned char b) {
           return std::tolower(a) == std::tolower(b);
         });
}

/// Numbers behind a name, in the first line that begins with it; commas and brackets are blanks.
std::vector<double> numbersOf(const std::string& bytes, const std::string& name)
{
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);) {
    if (!begins(line, name)) continue;
    line.erase(0, name.size());
    for (char& c : line)
      if (c == '(' || c == ')' || c == ',') c = ' ';
    std::istringstream words(line);
    std::vector<double> numbers;
    for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
    return numbers;
  }
  return {};
}

double bytesByName(const std::string& bytes, const std::string& field)
{
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);) {
    if (!begins(line, field)) continue;
    std::string type;
    for (const char c : line.substr(field.size())) type += static_cast<char>(std::tolower(c));
    const auto has = [&type](const char* part) { return type.find(part) != std::string::npos; };
    if (has("double")) return 8.0;
    if (has("float") || has("int32")) return 4.0;
    if (has("short") || has("int16")) return 2.0;
    if (has("char") || has("int8")) return 1.0;
    return has("int") ? 4.0 : 0.0;
  }
  return 0.0;
}

Stated statedByText(const std::string& bytes, bool isMeta)
{
  Stated stated;
  const auto directions = numbersOf(bytes, isMeta ? "TransformMatrix =" : "space directions:");
  const auto spacing = numbersOf(bytes, isMeta ? "ElementSpacing =" : "spacings:");
  const auto sizes = numbersOf(bytes, isMeta ? "DimSize =" : "sizes:");
  if (directions.size() != 9 || spacing.size() != 3 || sizes.size() != 3) return stated;
  stated.axes = Eigen::Map<const Eigen::Matrix3d>(directions.data());
  const Eigen::Vector3d lengths = stated.axes.colwise().norm().transpose(),
                        steps(spacing[0], spacing[1], spacing[2]);
  stated.sizes_mm = {steps, isMeta ? Eigen::Vector3d(steps.cwiseProduct(lengths)) : lengths};
  const std::string end = isMeta ? "LOCAL\n" : "\n\n";
  stated.headerBytes = static_cast<double>(bytes.find(end) + end.size());
  stated.dataBytes =
      bytesByName(bytes, isMeta ? "ElementType" : "type:") * sizes[0] * sizes[1] * sizes[2];
  return stated;
}

/// Why a file must not be read without a word; empty if nothing contradicts.
std::string contradictionIn(const Stated& stated, std::size_t fileBytes)
{
  if (stated.sizes_mm.empty()) return "";  // not understood by the judge
  for (const Eigen::Vector3d& size : stated.sizes_mm) {
    const Eigen::Vector3d parted = (size - stated.sizes_mm.front()).cwiseAbs();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (!(parted[axis] <= 1.01e-3 * size[axis])) return "two voxel sizes";
      if (!(size[axis] > 0.0099 && size[axis] < 10.1)) return "no voxel size of a CT";
    }
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (!(std::fabs(stated.axes.col(axis).normalized().dot(
              stated.axes.col((axis + 1) % 3).normalized())) < 1.1e-3))
      return "no right angles";
  if (stated.headerBytes + stated.dataBytes != static_cast<double>(fileBytes))
    return "another length";
  return "";
}

/// What of a file is packed.
enum class Packed { nothing, voxels, voxelsByZlib, all };

struct Format {
  const char* name;
  std::string content;  ///< Not packed.
  std::size_t headerBytes;
  Packed packed = Packed::nothing;
};

/// The bytes of a file of such a content.
std::string fileOf(const Format& format, const std::string& content)
{
  const std::size_t header = std::min(format.headerBytes, content.size());
  const std::string voxels = content.substr(header);
  switch (format.packed) {
    case Packed::voxels:
      return content.substr(0, header) + gzipped(voxels);
    case Packed::voxelsByZlib:
      return content.substr(0, header) + zipped(voxels);
    case Packed::all:
      return gzipped(content);
    case Packed::nothing:
      break;
  }
  return content;
}

std::vector<Format> formats()
{
  const std::string voxels = obliqueVoxels();
  std::string header = nrrdHeader("short", "raw", "LPS", 1.0);
  header = replaced(header, "\nkinds", "\nspacings: 0.3 0.4 0.6\nkinds");
  const std::string packedHeader = replaced(header, "encoding: raw", "encoding: gzip");
  const std::string packedMeta = metaHeader("ElementSize = 0.3 0.4 0.6\nCompressedData = True\n");
  const std::string meta = metaHeader("ElementSize = 0.3 0.4 0.6\nAnatomicalOrientation = RAI\n");
  return {{"sform.nii", niftiFile(obliqueCt(), Form::sform).content, 348},
          {"both.nii", niftiFile(obliqueCt(), Form::both).content, 348},
          {"packed.nii.gz", niftiFile(obliqueCt(), Form::sform).content, 348, Packed::all},
          {"a.nrrd", header + voxels, header.size()},
          {"packed.nrrd", packedHeader + voxels, packedHeader.size(), Packed::voxels},
          {"packed.mha", packedMeta + voxels, packedMeta.size(), Packed::voxelsByZlib},
          {"a.mha", meta + voxels, meta.size()}};
}

/// One to four bytes of the header changed: any byte, a bit, or a digit by another.
std::string changed(const Format& format, Random& random)
{
  std::string content = format.content;
  std::uniform_int_distribution<std::size_t> place(0, format.headerBytes - 1);
  const auto number = [&random](unsigned below) { return static_cast<unsigned>(random() % below); };
  for (unsigned left = 1 + number(4); left > 0; --left) {
    std::size_t at = place(random);
    const unsigned kind = number(3);
    if (kind == 0) content[at] = static_cast<char>(number(256));
    if (kind == 1) content[at] = static_cast<char>(content[at] ^ (1 << number(8)));
    if (kind == 2) {
      const std::size_t digit = content.find_first_of("0123456789", at);
      if (digit < format.headerBytes) at = digit;
      content[at] = static_cast<char>('0' + number(10));
    }
  }
  return content;
}

/// In one of three calls, without any number of the last third of the bytes.
std::string cutShort(std::string bytes, Random& random)
{
  if (random() % 3 == 0) bytes.resize(bytes.size() - random() % (bytes.size() / 3));
  return bytes;
}

constexpr int wasAccepted = 1, wasRefused = 2, wasContradicted = 3;

/// Reads a changed file and judges the answer.
int judged(const fs::path& file, const std::string& content)
{
  const auto loaded = readCt(file);
  if (!loaded)
    return loaded.error().message.find('\n') == std::string::npos ? wasRefused : wasContradicted;
  for (const std::string& warning : loaded->series.warnings)
    if (warning.find("twice") != std::string::npos) return wasAccepted;
  const std::string ending = file.extension().string();
  const Stated stated = ending == ".nii" || ending == ".gz"
                            ? statedByNifti(content)
                            : statedByText(content, ending == ".mha");
  const std::string why = contradictionIn(stated, content.size());
  if (!why.empty()) std::ofstream(file.string() + ".why") << why;
  return why.empty() ? wasAccepted : wasContradicted;
}

/// The same in a child with 10 s of processor time and 1 GB of addresses.
int judgedInChild(const fs::path& file, const std::string& content)
{
  const ::pid_t child = ::fork();
  if (child == 0) {
    const rlimit seconds = {10, 10}, bytes = {1u << 30, 1u << 30};
    ::setrlimit(RLIMIT_CPU, &seconds);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    ::setrlimit(RLIMIT_AS, &bytes);  // a sanitizer needs more
#else
    static_cast<void>(bytes);
#endif
    ::_exit(judged(file, content));
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(ChangedVolumeHeaders, NeitherCrashNorContradictThemselves)
{
  const test::TemporaryFolder folder;
  for (const Format& format : formats()) {
    const fs::path file = folder / format.name;
    Random random(43);
    std::ofstream(file, std::ios::binary) << fileOf(format, format.content);
    ASSERT_EQ(judgedInChild(file, format.content), wasAccepted) << format.name << ": the original";
    int read = 0;
    for (int change = 0; change < HEADER_CHANGES; ++change) {
      const std::string content = cutShort(changed(format, random), random);
      const std::string whole = fileOf(format, content), bytes = cutShort(whole, random);
      std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
      int answer = judgedInChild(file, content);
      if (answer == wasAccepted && bytes != whole) answer = wasContradicted;
      std::string why;
      std::getline(std::ifstream(file.string() + ".why"), why);
      ASSERT_TRUE(answer == wasAccepted || answer == wasRefused)
          << format.name << ", change " << change << ": " << answer << " " << why << "\n"
          << (format.headerBytes == 348 ? "" : content.substr(0, format.headerBytes));
      read += answer == wasAccepted ? 1 : 0;
    }
    RecordProperty(std::string(format.name) + "_read", read);
    EXPECT_GT(read, 0) << format.name;
    EXPECT_LT(read, HEADER_CHANGES) << format.name;
  }
}

}  // namespace
}  // namespace perilymph::imaging
