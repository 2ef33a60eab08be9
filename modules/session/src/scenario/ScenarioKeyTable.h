// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "perilymph/foundation/FieldMeaning.h"

namespace perilymph::session {

/// Every key of a scenario outside the table `patient_numbers`, in the order of subjects. Default and
/// allowed values are where a key is read.
const FieldMeanings& scenarioKeyTable();

}  // namespace perilymph::session
