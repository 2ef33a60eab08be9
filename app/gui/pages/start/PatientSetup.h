#pragma once

// From the numbers of a patient to a setup of their own.

#include "gui/setup/Setup.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Keeps the patient in a file among the patients and makes a setup of it: in the mean cochlea
/// where A, B and H are known, else in the published one. Numbers that are not the standard ones
/// count as measured in CT, as the form says.
Result<Setup> setupOfPatient(const anatomy::Patient& patient);

}  // namespace perilymph::gui
