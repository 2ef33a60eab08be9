// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Converts a patient's numbers to a setup.

#include "gui/setup/Setup.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Saves the patient to a file in the patient folder and makes a setup: with the mean cochlea if A,
/// B and H are given, else with the published one. Numbers other than the standard ones count as
/// measured in CT, as the form states.
Result<Setup> setupOfPatient(const anatomy::Patient& patient);

}  // namespace perilymph::gui
