// SPDX-License-Identifier: BSD-3-Clause
#include "library/SessionIndex.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "perilymph/foundation/AtomicFile.h"
#include "recording/HighlightKeys.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Incremented when the keys or their meaning change; an index with another number is ignored.
constexpr int format = 6;

constexpr std::pair<const char*, std::string SessionSummary::*> texts[] = {
    {"started_utc", &SessionSummary::startedUtc},
    {"scenario", &SessionSummary::scenario},
    {"patient", &SessionSummary::patient},
    {"side", &SessionSummary::side},
    {"array", &SessionSummary::array},
    {"technique", &SessionSummary::technique},
    {"device", &SessionSummary::device},
    {"version", &SessionSummary::version}};

json toJson(const SessionSummary& summary)
{
  json entry = {{"bytes", summary.bytes},
                {"modified_ns", summary.modified_ns},
                {"ticks", summary.highlights.ticks},
                {"closed", summary.wasClosed},
                {"error", static_cast<const std::string&>(summary.error)},
                {highlightEnd, haptics::nameOf(summary.highlights.end)}};
  for (const auto& [key, text] : texts) entry[key] = summary.*text;
  for (const auto& [key, number] : highlightKeys) entry[key] = summary.highlights.*number;
  return entry;
}

/// Throws nlohmann's exceptions for an invalid entry.
SessionSummary fromJson(const json& entry)
{
  SessionSummary summary;
  entry.at("bytes").get_to(summary.bytes);
  entry.at("modified_ns").get_to(summary.modified_ns);
  entry.at("ticks").get_to(summary.highlights.ticks);
  entry.at("closed").get_to(summary.wasClosed);
  summary.error = entry.at("error").get<std::string>();
  summary.highlights.end = haptics::endNamed(entry.at(highlightEnd).get<std::string>());
  for (const auto& [key, text] : texts) entry.at(key).get_to(summary.*text);
  for (const auto& [key, number] : highlightKeys) entry.at(key).get_to(summary.highlights.*number);
  return summary;
}

}  // namespace

SessionIndex::SessionIndex(const fs::path& folder)
{
  const auto cache = makeLibraryCache(folder);
  if (!cache) return;
  file_ = *cache / "index.json";
  read();
}

void SessionIndex::read()
{
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(file_, ignored))) return;
  const auto text = readWhole(file_);
  if (!text) return;
  try {
    const json index = json::parse(*text);
    if (index.at("format") != format) return;
    for (const auto& [name, entry] : index.at("sessions").items())
      known_.emplace(name, fromJson(entry));
  } catch (const json::exception&) {
    known_.clear();
  }
}

std::optional<SessionSummary> SessionIndex::find(const std::string& name, std::uint64_t bytes,
                                                 std::int64_t modified_ns) const
{
  const auto found = known_.find(name);
  if (found == known_.end() || found->second.bytes != bytes ||
      found->second.modified_ns != modified_ns)
    return std::nullopt;
  return found->second;
}

void SessionIndex::keep(const SessionSummary& summary)
{
  known_.insert_or_assign(summary.file.filename().string(), summary);
  hasChanged_ = true;
}

void SessionIndex::removeAbsent(const std::set<std::string>& present)
{
  if (std::erase_if(known_,
                    [&present](const auto& each) { return present.count(each.first) == 0; }) > 0)
    hasChanged_ = true;
}

void SessionIndex::close()
{
  if (file_.empty() || !hasChanged_) return;
  json sessions = json::object();
  for (const auto& [name, summary] : known_) sessions[name] = toJson(summary);
  const json index = {{"format", format}, {"sessions", std::move(sessions)}};
  // A link in its place is removed, not followed.
  std::error_code ignored;
  if (fs::is_symlink(fs::symlink_status(file_, ignored))) fs::remove(file_, ignored);
  // The index is optional; a name that is not UTF-8 only causes its recording to be read again.
  static_cast<void>(writeWhole(file_, index.dump(-1, ' ', false, json::error_handler_t::ignore)));
  hasChanged_ = false;
}

}  // namespace perilymph::session
