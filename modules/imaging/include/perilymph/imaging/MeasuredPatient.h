// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The patient file of a cochlea measured in a CT.

#include <filesystem>
#include <string>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// The patient of a measured cochlea, without a label: A, B, H to a micrometer, their errors, the
/// side, and the origin: software, series, landmarks by hand and proposed. Without an H that patients
/// may not have.
anatomy::Patient measuredPatient(const ct::CochleaMeasures& measures);

/// Text of the file of a measured patient. Scanner and flags are comments. Refuses a cochlea with
/// fewer turns than the model is built with.
Result<std::string> measuredPatientText(const ct::CochleaMeasures& measures,
                                        const std::string& label);

/// Writes it to a file.
Result<Done> writeMeasuredPatient(const ct::CochleaMeasures& measures, const std::string& label,
                                  const std::filesystem::path& file);

}  // namespace perilymph::imaging
