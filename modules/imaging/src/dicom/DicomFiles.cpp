// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFiles.h"

#include <algorithm>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "ParserTrial.h"

namespace perilymph::imaging {

namespace fs = std::filesystem;

namespace {

Error tooMany(const fs::path& path)
{
  return Error{path.string() + " holds more than " + std::to_string(maxCtFiles) +
               " files. Give the folder of one examination."};
}

Result<std::vector<fs::path>> filesBelow(const fs::path& folder, const ReadingHooks& hooks)
{
  std::vector<fs::path> files;
  std::error_code failed;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         failed);
  if (failed)
    return Error{folder.string() + " cannot be read: " + failed.message() +
                 ". Check its name and permissions."};
  for (const fs::recursive_directory_iterator end; entry != end; entry.increment(failed)) {
    if (failed) break;
    if (hooks.isCanceled && hooks.isCanceled()) return canceledReading();
    std::error_code ignored;
    if (!entry->is_regular_file(ignored)) continue;
    files.push_back(entry->path());
    if (files.size() > maxCtFiles) return tooMany(folder);
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What is listed in place of a file that cannot be parsed.
DicomHeader unreadable(const fs::path& file)
{
  DicomHeader header;
  header.file = file;
  header.isTruncated = true;
  return header;
}

}  // namespace

Error canceledReading() { return Error{"Reading was canceled."}; }

Result<DicomFiles> listDicomFiles(const fs::path& path, const ReadingHooks& hooks)
{
  std::error_code failed;
  const bool isFolder = fs::is_directory(path, failed);
  std::vector<fs::path> files = {path};
  if (isFolder) {
    auto below = filesBelow(path, hooks);
    if (!below) return below.error();
    files = *std::move(below);
  }
  auto ending = filesThatEndTheParser(files, hooks.isCanceled);
  if (hooks.isCanceled && hooks.isCanceled()) return canceledReading();
  auto named = isFolder || !ending.empty() ? std::nullopt : filesOfDicomDir(path);
  if (named) {
    files = *std::move(named);
    if (files.size() > maxCtFiles) return tooMany(path);
    std::erase_if(files, [](const fs::path& file) {
      std::error_code ignored;
      return !fs::is_regular_file(file, ignored);
    });
    if (files.empty())
      return Error{
          path.string() +
          " is a DICOMDIR, but none of the files it names is there. Copy the whole medium, "
          "or give a folder of images."};
    ending = filesThatEndTheParser(files, hooks.isCanceled);
  }
  DicomFiles found;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (hooks.isCanceled && hooks.isCanceled()) return canceledReading();
    if (ending.contains(files[i]))
      found.headers.push_back(unreadable(files[i]));
    else if (auto header = readDicomHeader(files[i]))
      found.headers.push_back(*std::move(header));
    else
      ++found.others;
    if (hooks.onProgress)
      hooks.onProgress(static_cast<double>(i + 1) / static_cast<double>(files.size()));
  }
  // A DICOMDIR in the folder is a table of contents and no image.
  std::erase_if(found.headers, [](const DicomHeader& header) {
    return header.sopClass.empty() && header.modality.empty() && !header.hasPixels &&
           !header.isTruncated && header.coding != PixelCoding::deflated;
  });
  return found;
}

}  // namespace perilymph::imaging
