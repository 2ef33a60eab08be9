// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Running a study: in one process, or in shards of which each is a process anywhere.

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/study/Study.h"
#include "perilymph/study/StudyFile.h"

namespace perilymph::study {

/// A part of a study: consecutive cases.
struct Shard {
  std::size_t index = 1, count = 1;  ///< Number `index` of `count`, from 1.
  std::size_t first = 0, end = 0;    ///< Cases first to end - 1.
};
/// Part `index` of a study of `cases` insertions; parts differ by one insertion at most.
Shard shardOf(std::size_t cases, std::size_t index, std::size_t count);
/// "shard-3-of-16.sqlite".
std::string fileNameOf(const Shard& shard);

/// Runs a shard into its file in the folder, or resumes an earlier run. Results are
/// written in the order of their cases by transactions: whatever ends the process, those that were written
/// remain. An insertion that cannot be prepared or that ends early is a result; those not yet written when a
/// file of the study was changed are discarded.
///
/// @param jobs  Threads; 0: one per processor. Results do not depend on it.
/// @return      True if the shard is complete, false if it was stopped. Refuses a file of another
///              study, of another version of the study or of another build of the program.
Result<bool> runShard(const Study& study, const Shard& shard, const std::filesystem::path& folder,
                      unsigned jobs, const analysis::RunProgress& progress = {},
                      const std::stop_token& stop = {});

/// State of one shard's file in a folder.
struct ShardState {
  std::filesystem::path file;
  Shard shard;                     ///< Without index and count if the file is not readable.
  std::size_t done = 0;            ///< Insertions in it.
  std::size_t cases = 0;           ///< Insertions of the whole study.
  std::string fingerprint;         ///< Identity of the study.
  std::vector<std::string> notes;  ///< On its patients (Study::notes()).
  Sentence error;                  ///< Why it is not readable; empty if it is.
};
/// The shards in a folder, sorted by their first case.
Result<std::vector<ShardState>> shardsIn(const std::filesystem::path& folder);

/// Merges the complete shards of a folder into `study.sqlite` and `insertions.csv` in it. The same
/// study gives the same bytes, however it was divided. Refuses shards of different studies, and
/// missing, incomplete, overlapping or damaged ones by name, and states which to run again.
///
/// @return  What the merged file is of.
Result<StudyFileFacts> mergeShards(const std::filesystem::path& folder);

/// Names of the files that mergeShards() writes.
inline constexpr const char* mergedFile = "study.sqlite";
inline constexpr const char* mergedTable = "insertions.csv";

}  // namespace perilymph::study
