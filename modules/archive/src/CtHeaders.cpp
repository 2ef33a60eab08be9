// SPDX-License-Identifier: BSD-3-Clause
#include "CtHeaders.h"

#include <algorithm>
#include <system_error>

#include "Rows.h"
#include "perilymph/foundation/Sha256.h"

namespace perilymph::archive {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t maxFiles = 20'000;

void readHeader(const fs::path& file, const std::string& seriesKey, Headers& headers)
{
  auto header = std::make_unique<DcmFileFormat>();
  const OFCondition read = header->loadFileUntilTag(
      file.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect, DCM_PixelData);
  if (read.bad()) return;
  Sha256 hash;
  hash.add(textIn(*header->getDataset(), DCM_SeriesInstanceUID));
  if (hash.hex() == seriesKey) headers.push_back(std::move(header));
}

}  // namespace

Result<Headers> readHeaders(const fs::path& given, const std::string& seriesKey)
{
  std::error_code failed;
  Headers headers;
  const fs::path ct = given.filename() == "DICOMDIR" ? given.parent_path() : given;
  if (fs::is_regular_file(ct, failed)) {
    readHeader(ct, seriesKey, headers);
  } else {
    std::size_t files = 0;
    for (fs::recursive_directory_iterator place(ct, failed), end; !failed && place != end;
         place.increment(failed)) {
      if (!place->is_regular_file(failed)) continue;
      if (++files > maxFiles)
        return Error{"%1 holds more than %2 files. Give the folder of the one CT.", ct, maxFiles};
      readHeader(place->path(), seriesKey, headers);
    }
    if (failed) return Error{"%1 cannot be read: %2.", ct, failed.message()};
  }
  if (headers.empty())
    return Error{"%1 holds no file of the series that was measured. Give the folder of that CT.",
                 ct};
  return headers;
}

Result<void> checkSoftware(const std::string& software)
{
  const bool isText = software.size() <= maxLetters &&
                      std::all_of(software.begin(), software.end(),
                                  [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
  if (!isText) return Error{"The version of a report has at most 64 ASCII letters."};
  return {};
}

}  // namespace perilymph::archive
