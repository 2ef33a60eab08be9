// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The patient file of a cochlea measured in a CT.

#include <filesystem>
#include <string>

#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Writes a patient measured in a CT: A, B, H and the side, errors, provenance and who placed which
/// landmark as comments. An H that patients may not have is a comment, too.
Result<Done> writeMeasuredPatient(const ct::CochleaMeasures& measures, const std::string& label,
                                  const std::filesystem::path& file);

}  // namespace perilymph::imaging
