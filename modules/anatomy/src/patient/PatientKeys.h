// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "perilymph/foundation/FieldMeaning.h"

namespace perilymph::anatomy {

/// Every key of a patient's file. Default and allowed values are where a key is read.
const FieldMeanings& patientKeyTable();

}  // namespace perilymph::anatomy
