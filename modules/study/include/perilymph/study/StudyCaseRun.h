// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Running one insertion of a finished study again, with a recording.

#include <filesystem>
#include <stop_token>

#include "perilymph/foundation/Result.h"
#include "perilymph/study/StudyFile.h"

namespace perilymph::study {

/// The study that a file was made from, read from the text in it. Patients are looked for beside the
/// file. An error if these differ from those of the study.
Result<Study> studyIn(const StudyFileFacts& facts, const std::filesystem::path& file);

/// Runs insertion `number` of a study again and records it. A recording that exists is never
/// replaced: the error states it.
///
/// @return  What it gives now, to compare with the result in the file.
Result<StudyResult> recordCase(const Study& study, std::size_t number,
                               const std::filesystem::path& recording, const std::stop_token& stop);

}  // namespace perilymph::study
