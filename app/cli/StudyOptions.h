// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "perilymph/foundation/Result.h"
#include "perilymph/study/Study.h"

namespace CLI {
class App;
}

namespace perilymph::cli {

class CommandFiles;
class FileOptions;
struct StudyOptions;

/// Declares `study check`, `run`, `shard`, `merge`, `status`, `report` and `submit`.
void addStudy(CLI::App& app, FileOptions& files, StudyOptions& options);
/// Runs the one that was given.
Result<void> runStudy(const CLI::App& study, const CommandFiles& files,
                      const StudyOptions& options);

/// Reads the study of a call, and says on standard error which of its patients' measures were changed
/// by hand or carry no seal.
Result<study::Study> readStudy(const StudyOptions& options);

/// Checks, before the work, that a study's folder has no files of other origin that a merge would
/// replace.
Result<void> checkStudyFolder(const std::string& folder);

}  // namespace perilymph::cli
