// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From a measured cochlea to a patient and the setup of an insertion.

#include <QString>

#include "gui/setup/Setup.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Writes the patient file of a measured cochlea, with errors and provenance, and reads it back.
///
/// @param code    The patient's code.
/// @param former  Measures before these in the same CT, kept as a version before them; may be null.
/// Refuses measures that no patient may have, and files that cannot be written.
Result<anatomy::Patient> patientOfMeasures(const ct::CochleaMeasures& measures, const QString& code,
                                           const ct::CochleaMeasures* former = nullptr);

/// The same, and a setup of the mean anatomy with these measures and an approach.
Result<Setup> setupOfMeasures(const ct::CochleaMeasures& measures, const QString& code,
                              const anatomy::Approach& approach,
                              const ct::CochleaMeasures* former = nullptr);

}  // namespace perilymph::gui
