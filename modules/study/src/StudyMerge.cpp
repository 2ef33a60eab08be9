// SPDX-License-Identifier: BSD-3-Clause

// Shards in a folder: their state, and one file of all.

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>

#include "InsertionsTable.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/FileLock.h"
#include "perilymph/foundation/Unfinished.h"
#include "perilymph/study/StudyFile.h"
#include "perilymph/study/StudyRun.h"

namespace perilymph::study {

namespace {

namespace fs = std::filesystem;

/// Rows of one transaction of the merged file; a constant, so that its bytes do not depend on the
/// shards.
constexpr std::size_t rowsAtOnce = 1000;

/// The shards that together are the whole study, in order; or what is missing.
Result<std::vector<StudyFile>> wholeStudy(const fs::path& folder)
{
  const auto states = shardsIn(folder);
  if (!states) return states.error();
  if (states->empty())
    return Error{"%1 has no shards. Run 'perilymph-cli study run' or 'study shard' into it first.",
                 folder};
  std::vector<StudyFile> files;
  std::size_t next = 0;
  for (const ShardState& state : *states) {
    if (!state.error.empty()) return Error{state.error};
    auto file = StudyFile::open(state.file);
    if (!file) return file.error();
    const StudyFileFacts& facts = file->facts();
    const std::string name = state.file.string();
    const StudyFileFacts& one = files.empty() ? facts : files.front().facts();
    // A merged study is sealed anew: what its shards say must be what the program wrote.
    if (facts.seal != Seal::intact)
      return facts.seal == Seal::changed
                 ? Error{"%1 was changed after the program wrote it. Delete it and run its shard "
                         "again.",
                         name}
                 : Error{"%1 carries no seal: it is of an earlier version. Delete it and run its "
                         "shard again.",
                         name};
    if (facts.fingerprint != one.fingerprint || facts.program != one.program)
      return Error{
          "%1 is of another study or another build of the program than %2. Remove the one that "
          "does not belong here.",
          name, states->front().file.string()};
    if (state.done != facts.end - facts.first)
      return Error{"%1 is not complete (%2 of %3 insertions). Run its shard again.", name,
                   state.done, facts.end - facts.first};
    if (facts.first < next)
      return Error{
          "%1 has insertions that another shard has, too (from number %2). Remove the shards of "
          "one of the two divisions.",
          name, facts.first};
    if (facts.first > next)
      return Error{"The insertions %1 to %2 are missing in %3. Run their shard.", next,
                   facts.first - 1, folder};
    next = facts.end;
    files.push_back(*std::move(file));
  }
  if (next != files.front().facts().cases)
    return Error{"The insertions %1 to %2 are missing in %3. Run their shard.", next,
                 files.front().facts().cases - 1, folder};
  return files;
}

/// Calls `each` with every insertion of all shards.
Result<void> readAll(const std::vector<StudyFile>& files,
                     const std::function<Result<void>(const StudyResult&)>& each)
{
  for (const StudyFile& file : files)
    if (const auto done = file.read(each); !done) return done;
  return {};
}

/// Facts of the file that these together give.
StudyFileFacts factsOfAll(const std::vector<StudyFile>& files)
{
  StudyFileFacts facts = files.front().facts();
  facts.first = 0;
  facts.end = facts.cases;
  return facts;
}

/// Writes the merged file under a name that does not exist.
Result<void> writeMerged(const std::vector<StudyFile>& files, const fs::path& file)
{
  auto merged = StudyFile::openToContinue(file, factsOfAll(files));
  if (!merged) return merged.error();
  std::vector<StudyResult> rows;
  const auto flush = [&]() -> Result<void> {
    const auto done = merged->append(rows);
    rows.clear();
    return done;
  };
  const auto copied = readAll(files, [&](const StudyResult& result) -> Result<void> {
    rows.push_back(result);
    return rows.size() < rowsAtOnce ? Result<void>() : flush();
  });
  if (!copied) return copied;
  if (const auto done = flush(); !done) return done;
  return merged->close();
}

}  // namespace

Result<std::vector<ShardState>> shardsIn(const fs::path& folder)
{
  std::error_code problem;
  std::vector<ShardState> states;
  fs::directory_iterator entry(folder, problem);
  if (problem) return Error{"%1 cannot be read: %2. Check the name.", folder, problem.message()};
  for (; entry != fs::directory_iterator(); entry.increment(problem)) {
    if (problem) return Error{"%1 cannot be read: %2.", folder, problem.message()};
    const std::string name = entry->path().filename().string();
    if (!name.starts_with("shard-") || !name.ends_with(".sqlite")) continue;
    ShardState state;
    state.file = entry->path();
    const auto outline = StudyFile::outlineOf(state.file);
    if (!outline) {
      state.error = outline.error().message;
    } else {
      state.shard.first = outline->first.first;
      state.shard.end = outline->first.end;
      state.done = outline->second;
      state.cases = outline->first.cases;
      state.fingerprint = outline->first.fingerprint;
      state.notes = outline->first.notes;
    }
    states.push_back(state);
  }
  std::sort(states.begin(), states.end(), [](const ShardState& a, const ShardState& b) {
    return a.shard.first != b.shard.first ? a.shard.first < b.shard.first : a.file < b.file;
  });
  return states;
}

Result<StudyFileFacts> mergeShards(const fs::path& folder)
{
  std::error_code failure;
  if (!fs::is_directory(folder, failure))
    return Error{"%1 cannot be read: it is no folder. Check the name.", folder};
  const auto lock =
      FileLock::take(folder / (std::string(mergedFile) + ".lock"), (folder / mergedFile).string());
  if (!lock) return lock.error();
  const auto files = wholeStudy(folder);
  if (!files) return files.error();
  std::set<std::string> settings;
  const auto listed = readAll(*files, [&](const StudyResult& result) -> Result<void> {
    for (const auto& [key, value] : result.settings) settings.insert(key);
    return {};
  });
  if (!listed) return listed.error();

  std::optional<Result<void>> copied;
  const auto table =
      writeWhole(folder / mergedTable,
                 [&](const fs::path& place) {
                   std::ofstream stream(place, std::ios::binary);
                   stream << insertionsHeader(settings);
                   copied = readAll(*files, [&](const StudyResult& result) -> Result<void> {
                     stream << insertionsRow(result, settings);
                     return {};
                   });
                   stream.close();
                   return stream.good() && static_cast<bool>(*copied);
                 },
                 {Links::refused});
  if (copied && !*copied) return copied->error();
  if (!table) return table.error();
  // Under another name until it is whole.
  const fs::path unfinished = unfinishedPath(folder / mergedFile);
  const auto written = writeMerged(*files, unfinished);
  std::error_code problem;
  if (written) fs::rename(unfinished, folder / mergedFile, problem);
  std::error_code ignored;
  for (const char* ending : {"", "-wal", "-shm", "-journal"})
    fs::remove(unfinished.string() + ending, ignored);
  if (!written) return written.error();
  if (problem) return Error{"%1 cannot be written: %2.", folder / mergedFile, problem.message()};
  return factsOfAll(*files);
}

}  // namespace perilymph::study
