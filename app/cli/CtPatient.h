// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Writes a patient measured in a CT: A, B, H and the side, errors and provenance as comments. An H
/// that patients may not have is a comment, too.
Result<Done> writeMeasuredPatient(const ct::CochleaMeasures& measures,
                                  const std::filesystem::path& file);

}  // namespace perilymph::cli
