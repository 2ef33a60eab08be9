// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Outcomes of all patients, read in the background and compared with their plans.

#include <stop_token>
#include <vector>

#include "perilymph/outcome/ClinicLibrary.h"

namespace perilymph::gui {

struct AllOutcomes {
  outcome::ClinicOutcomes clinic;
  std::vector<anatomy::Patient> patients;  ///< Whose each of its ears is.
  std::vector<Sentence> notes;             ///< What was left out, and why.
};

/// The newest outcome of every saved ear beside the plan that was made before its surgery; seconds for many.
/// Any thread.
Result<AllOutcomes> allOutcomes(const std::stop_token& stop);

}  // namespace perilymph::gui
