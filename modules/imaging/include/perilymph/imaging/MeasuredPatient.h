// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The patient file of a cochlea measured in a CT.

#include <filesystem>
#include <optional>
#include <string>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Sentence.h"

namespace perilymph::imaging {

/// The patient of a measured cochlea, without a label: A, B, H to a micrometer, their errors, the
/// side, and the origin: software, series, landmarks by hand and proposed. An H outside the limits of
/// patients (anatomy::limitsOfH()) is the nearer limit if that is within its 95 % interval, and missing
/// beyond; heightNote() states it.
anatomy::Patient measuredPatient(const ct::CochleaMeasures& measures);

/// A sentence about an H that measuredPatient() changes or leaves out; none if it is used as measured.
std::optional<Sentence> heightNote(const ct::CochleaMeasures& measures);

/// Text of the file of a measured patient. Scanner and flags are comments. Refuses a cochlea with
/// fewer turns than the model is built with.
Result<std::string> measuredPatientText(const ct::CochleaMeasures& measures,
                                        const std::string& label);

/// Writes it to a file.
Result<void> writeMeasuredPatient(const ct::CochleaMeasures& measures, const std::string& label,
                                  const std::filesystem::path& file);

}  // namespace perilymph::imaging
