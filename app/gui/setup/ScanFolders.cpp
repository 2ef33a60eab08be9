// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/ScanFolders.h"

#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/StateFolder.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxScans = 1000;
constexpr std::size_t maxBytes = std::size_t{1} << 22;

fs::path scansFile() { return stateFolder() / "ct-folders"; }

/// A series and its place, the oldest first: a line each, with a space between both.
std::vector<std::pair<std::string, std::string>> knownScans()
{
  std::vector<std::pair<std::string, std::string>> known;
  const auto text = readWhole(scansFile(), maxBytes);
  if (!text) return known;  // none was remembered yet
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t space = line.find(' '); space != std::string::npos)
      known.emplace_back(line.substr(0, space), line.substr(space + 1));
  return known;
}

}  // namespace

void rememberScan(const std::string& series, const fs::path& place)
{
  std::error_code failure;
  const std::string whole = fs::absolute(place, failure).string();
  if (failure || series.empty() || whole.find('\n') != std::string::npos) return;
  auto known = knownScans();
  std::erase_if(known, [&series](const auto& each) { return each.first == series; });
  known.emplace_back(series, whole);
  if (known.size() > maxScans) known.erase(known.begin());
  std::string text;
  for (const auto& [key, path] : known) text += key + ' ' + path + '\n';
  fs::create_directories(stateFolder(), failure);
  // without it the user opens the folder again
  static_cast<void>(writeWhole(scansFile(), text, {Links::refused, Audience::owner}));
}

fs::path placeOfScan(const std::string& series)
{
  for (const auto& [key, path] : knownScans())
    if (key == series) return path;
  return {};
}

}  // namespace perilymph::gui
