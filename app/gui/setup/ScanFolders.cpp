// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/ScanFolders.h"

#include <algorithm>
#include <sstream>
#include <system_error>

#include "gui/setup/PatientLibrary.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/foundation/UtcTime.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxScans = 1000;
constexpr std::size_t maxRecent = 8;  // what a menu holds without being searched
constexpr std::size_t maxBytes = std::size_t{1} << 22;

fs::path scansFile() { return stateFolder() / "ct-folders"; }

/// A line: series, date, code (a dot if unknown) and place; of earlier versions, series and place.
ReadScan scanIn(const std::string& line)
{
  std::istringstream words(line);
  ReadScan scan;
  words >> scan.series >> std::ws;
  if (words.peek() != '/') {
    words >> scan.utc >> scan.code >> std::ws;
    if (scan.code == ".") scan.code.clear();
  }
  std::string place;
  std::getline(words, place);
  scan.place = place;
  return scan;
}

std::string lineOf(const ReadScan& scan)
{
  const std::string code = scan.code.empty() ? "." : scan.code;
  return scan.series + ' ' + (scan.utc.empty() ? "" : scan.utc + ' ' + code + ' ') +
         scan.place.string() + '\n';
}

/// What was read, the oldest first.
std::vector<ReadScan> knownScans()
{
  std::vector<ReadScan> known;
  const auto text = readWhole(scansFile(), maxBytes);
  if (!text) return known;  // none was remembered yet
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);)
    if (ReadScan scan = scanIn(line); scan.place.is_absolute()) known.push_back(std::move(scan));
  return known;
}

bool isFetched(const fs::path& place)
{
  const fs::path below = place.lexically_relative(stateFolder() / "archive");
  return !below.empty() && *below.begin() != "..";
}

}  // namespace

void rememberScan(const std::string& series, const fs::path& place, const std::string& code)
{
  std::error_code failure;
  const fs::path whole = fs::absolute(place, failure);
  if (failure || series.empty() || whole.string().find('\n') != std::string::npos) return;
  auto known = knownScans();
  const auto before = std::find_if(known.begin(), known.end(),
                                   [&](const ReadScan& each) { return each.series == series; });
  // what is no code may be a name
  ReadScan scan{series, whole, utcNow(), anatomy::checkPatientCode(code) ? code : std::string()};
  if (before != known.end()) {
    if (scan.code.empty()) scan.code = before->code;
    known.erase(before);
  }
  known.push_back(std::move(scan));
  if (known.size() > maxScans) known.erase(known.begin());
  std::string text;
  for (const ReadScan& each : known) text += lineOf(each);
  fs::create_directories(stateFolder(), failure);
  // without it the user opens the folder again
  static_cast<void>(writeWhole(scansFile(), text, {Links::refused, Audience::owner}));
}

fs::path placeOfScan(const std::string& series)
{
  for (const ReadScan& each : knownScans())
    if (each.series == series) return each.place;
  return {};
}

std::vector<ReadScan> recentScans()
{
  auto known = knownScans();
  std::erase_if(known,
                [](const ReadScan& each) { return each.utc.empty() || isFetched(each.place); });
  std::reverse(known.begin(), known.end());
  if (known.size() > maxRecent) known.resize(maxRecent);
  return known;
}

bool clearScans()
{
  std::error_code failure;
  fs::remove(scansFile(), failure);
  return !failure;
}

}  // namespace perilymph::gui
