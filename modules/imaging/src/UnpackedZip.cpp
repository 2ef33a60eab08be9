// SPDX-License-Identifier: BSD-3-Clause
#include "UnpackedZip.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stop_token>
#include <string>
#include <system_error>
#include <vector>

#include "UntrustedRead.h"

namespace perilymph::imaging {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t maxUnpackedBytes = std::uint64_t{4} << 30;
/// Voxels of a CT are packed to a third, empty ones to a fiftieth; small archives may be of anything.
constexpr std::uint64_t maxPacking = 100, smallBytes = std::uint64_t{64} << 20;
constexpr std::size_t maxUnpackerBytes = std::size_t{256} << 20;

enum class Unpacking : int { done, damaged, encrypted, tooManyFiles, tooLarge, notWritten };

/// What is plain of a name: its last part in letters, digits, points and dashes.
std::string plainPart(const std::string& name)
{
  constexpr std::size_t longest = 64;
  std::string plain;
  for (const char c : name.substr(name.find_last_of("/\\") + 1))
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_')
      plain += c;
  return plain.substr(0, longest);
}

/// Closes an archive and its files.
struct Closing {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

Unpacking unpackEntry(zip_t& archive, std::uint64_t index, std::uint64_t size,
                      const fs::path& target)
{
  const std::unique_ptr<zip_file_t, Closing> entry(zip_fopen_index(&archive, index, 0));
  if (!entry) return Unpacking::damaged;
  std::ofstream file(target, std::ios::binary);
  std::vector<char> chunk(std::size_t{1} << 16);
  std::uint64_t read = 0;
  while (true) {
    const zip_int64_t bytes = zip_fread(entry.get(), chunk.data(), chunk.size());
    if (bytes < 0) return Unpacking::damaged;
    if (bytes == 0) break;
    read += static_cast<std::uint64_t>(bytes);
    if (read > size) return Unpacking::damaged;
    if (!file.write(chunk.data(), bytes)) return Unpacking::notWritten;
  }
  if (read != size) return Unpacking::damaged;
  file.close();
  return file ? Unpacking::done : Unpacking::notWritten;
}

Unpacking unpackInto(const fs::path& zip, const fs::path& folder, std::size_t maxFiles)
{
  int failed = 0;
  const std::unique_ptr<zip_t, Closing> archive(zip_open(zip.c_str(), ZIP_RDONLY, &failed));
  if (!archive) return Unpacking::damaged;
  const zip_int64_t entries = zip_get_num_entries(archive.get(), 0);
  if (entries < 0) return Unpacking::damaged;
  if (static_cast<std::uint64_t>(entries) > 2 * maxFiles) return Unpacking::tooManyFiles;
  std::uint64_t unpacked = 0, packed = 0;
  std::size_t files = 0;
  std::vector<std::pair<std::uint64_t, fs::path>> wanted;
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(entries); ++i) {
    zip_stat_t entry;
    zip_stat_init(&entry);
    constexpr zip_uint64_t needed = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
    if (zip_stat_index(archive.get(), i, 0, &entry) != 0 || (entry.valid & needed) != needed)
      return Unpacking::damaged;
    const std::string name = entry.name;
    if (name.empty() || name.back() == '/') continue;
    if ((entry.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && entry.encryption_method != ZIP_EM_NONE)
      return Unpacking::encrypted;
    if (++files > maxFiles) return Unpacking::tooManyFiles;
    if (entry.size > maxUnpackedBytes || entry.comp_size > maxUnpackedBytes)
      return Unpacking::tooLarge;
    unpacked += entry.size;
    packed += entry.comp_size;
    if (unpacked > maxUnpackedBytes) return Unpacking::tooLarge;
    char number[24];
    std::snprintf(number, sizeof number, "%06zu-", files);
    wanted.emplace_back(i, folder / (number + plainPart(name)));
    sizes.push_back(entry.size);
  }
  if (unpacked > smallBytes && unpacked > maxPacking * packed) return Unpacking::tooLarge;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (const Unpacking answer = unpackEntry(*archive, wanted[k].first, sizes[k], wanted[k].second);
        answer != Unpacking::done)
      return answer;
  return Unpacking::done;
}

Error refusalOf(const fs::path& zip, Unpacking answer, std::size_t maxFiles)
{
  const std::string name = zip.string();
  switch (answer) {
    case Unpacking::encrypted:
      return Error{"%1 is encrypted. Unpack it with its password, and give the folder.", name};
    case Unpacking::tooManyFiles:
      return Error{"%1 holds more than %2 files. Give the folder of one examination.", name,
                   maxFiles};
    case Unpacking::tooLarge:
      return Error{
          "%1 unpacks to more than 4 GB, or to more than a hundred times its size. Unpack it, and "
          "give the folder of one series.",
          name};
    case Unpacking::notWritten:
      return Error{
          "%1 cannot be unpacked: the folder for temporary files (TMPDIR) is missing, full or not "
          "writable. Make space, or unpack it and give the folder.",
          name};
    default:
      return Error{
          "%1 is a damaged .zip, or took more than a minute to unpack. Copy it again, or unpack it "
          "and give the folder.",
          name};
  }
}

}  // namespace

bool isZip(const fs::path& file)
{
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return false;
  std::array<char, 4> start{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), start.size());
  return stream && start[0] == 'P' && start[1] == 'K' &&
         ((start[2] == 3 && start[3] == 4) || (start[2] == 5 && start[3] == 6));
}

Result<std::shared_ptr<const UnpackedZip>> UnpackedZip::unpack(const fs::path& zip,
                                                               std::size_t maxFiles,
                                                               const std::stop_token& stop)
{
  std::error_code failed;
  auto folder = UnfinishedFolder::create(fs::temp_directory_path(failed) / "perilymph-zip");
  if (failed || !folder) return refusalOf(zip, Unpacking::notWritten, maxFiles);
  auto unpacked = std::make_shared<const UnpackedZip>(*std::move(folder));
  const auto work = [&] { return static_cast<int>(unpackInto(zip, unpacked->folder(), maxFiles)); };
  const auto answer = static_cast<Unpacking>(runInChild(work, {maxUnpackerBytes, stop, {}}));
  if (answer != Unpacking::done) return refusalOf(zip, answer, maxFiles);
  return unpacked;
}

}  // namespace perilymph::imaging
