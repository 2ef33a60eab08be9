// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFiles.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "../statements/Warnings.h"
#include "DicomDirectory.h"
#include "ParserTrial.h"
#include "SequenceDepth.h"

namespace perilymph::imaging {

namespace fs = std::filesystem;

namespace {

Error tooMany(const fs::path& path)
{
  return Error{"%1 holds more than %2 files. Give the folder of one examination.", path,
               maxCtFiles};
}

Result<std::vector<fs::path>> filesBelow(const fs::path& folder, const ReadingHooks& hooks)
{
  std::vector<fs::path> files;
  std::error_code failed;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         failed);
  if (failed)
    return Error{"%1 cannot be read: %2. Check its name and permissions.", folder,
                 failed.message()};
  for (const fs::recursive_directory_iterator end; entry != end; entry.increment(failed)) {
    if (failed) break;
    if (hooks.stop.stop_requested()) return canceledReading();
    std::error_code ignored;
    if (!entry->is_regular_file(ignored)) continue;
    files.push_back(entry->path());
    if (files.size() > maxCtFiles) return tooMany(folder);
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What is listed in place of a file that is not parsed.
DicomHeader notParsed(const fs::path& file, Sentence why)
{
  DicomHeader header;
  header.file = file;
  header.notParsed = std::move(why);
  header.isTruncated = header.notParsed.empty();
  return header;
}

/// True for what an interrupted copy leaves of a DICOM file: nothing, or a part of its first 132 bytes.
bool isStump(const fs::path& file)
{
  constexpr std::size_t preamble = 128;
  std::array<char, preamble + 5> start{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return false;
  stream.read(start.data(), start.size());
  const auto bytes = static_cast<std::size_t>(stream.gcount());
  if (bytes == start.size()) return false;
  return std::all_of(start.begin(),
                     start.begin() + static_cast<std::ptrdiff_t>(std::min(bytes, preamble)),
                     [](char c) { return c == '\0'; });
}

struct Paths {
  std::vector<fs::path> files;
  std::vector<Sentence> warnings;
};

/// The files that a path stands for.
Result<Paths> pathsOf(const fs::path& path, const ReadingHooks& hooks)
{
  std::error_code failed;
  Paths paths;
  if (fs::is_directory(path, failed)) {
    auto below = filesBelow(path, hooks);
    if (!below) return below.error();
    paths.files = *std::move(below);
    return paths;
  }
  paths.files = {path};
  if (isNestedTooDeep(path) || !filesThatEndTheParser(paths.files, hooks.stop)->empty())
    return paths;
  auto directory = readDicomDirectory(path);
  if (!directory) return paths;
  const std::size_t named = directory->files.size() + directory->missing;
  if (directory->files.empty()) {
    auto below = filesBelow(path.parent_path().empty() ? fs::path(".") : path.parent_path(), hooks);
    if (!below) return below.error();
    paths.files = *std::move(below);
    std::erase_if(paths.files,
                  [&path](const fs::path& file) { return file.filename() == path.filename(); });
    if (paths.files.empty())
      return Error{
          "%1 is a DICOMDIR, but none of the files it names is there. Copy the whole medium, or "
          "give a folder of images.",
          path};
    paths.warnings.push_back(Sentence(warnings::directoryLost, {std::to_string(named)}));
    return paths;
  }
  paths.files = std::move(directory->files);
  if (directory->missing > 0)
    paths.warnings.push_back(Sentence(warnings::directoryMissing,
                                      {std::to_string(directory->missing), std::to_string(named)}));
  if (paths.files.size() > maxCtFiles) return tooMany(path);
  return paths;
}

}  // namespace

Error canceledReading() { return Error{"Reading was canceled."}; }

Result<DicomFiles> listDicomFiles(const fs::path& path, const ReadingHooks& hooks,
                                  std::chrono::milliseconds longest)
{
  if (isZip(path)) {
    auto unpacked = UnpackedZip::unpack(path, maxCtFiles, hooks.stop);
    if (!unpacked) return hooks.stop.stop_requested() ? canceledReading() : unpacked.error();
    auto found = listDicomFiles((*unpacked)->folder(), hooks, longest);
    if (found) found->unpacked = *std::move(unpacked);
    return found;
  }
  auto paths = pathsOf(path, hooks);
  if (!paths) return paths.error();
  DicomFiles found;
  found.warnings = std::move(paths->warnings);
  std::vector<fs::path> files;
  for (const fs::path& file : paths->files) {
    if (isNestedTooDeep(file))
      found.headers.push_back(notParsed(
          file, Sentence{"sequences are nested deeper than %1, which no image needs. Export the "
                         "series again.",
                         maxSequenceDepth}));
    else
      files.push_back(file);
  }
  const auto ending = filesThatEndTheParser(files, hooks.stop, longest);
  if (hooks.stop.stop_requested()) return canceledReading();
  if (!ending)
    return Error{
        "%1 takes more than 5 minutes to list, because its files are damaged or on a slow drive. "
        "Copy the series to a folder of this computer.",
        path};
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (hooks.stop.stop_requested()) return canceledReading();
    if (ending->contains(files[i])) {
      found.headers.push_back(notParsed(files[i], {}));
    } else if (auto header = readDicomHeader(files[i])) {
      found.headers.push_back(*std::move(header));
    } else {
      if (isStump(files[i])) found.stumps.push_back(files[i]);
      ++found.others;
    }
    if (hooks.onProgress)
      hooks.onProgress(static_cast<double>(i + 1) / static_cast<double>(files.size()));
  }
  std::erase_if(found.headers, [&found](const DicomHeader& header) {
    const bool saysNothing = header.sopClass.empty() && header.modality.empty() &&
                             !header.hasPixels && !header.isTruncated && header.notParsed.empty() &&
                             header.coding != PixelCoding::deflated;
    if (saysNothing && !header.isDirectory) found.stumps.push_back(header.file);
    // A DICOMDIR in the folder is a table of contents and no image.
    return saysNothing || header.isDirectory;
  });
  return found;
}

}  // namespace perilymph::imaging
