// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "perilymph/foundation/FieldMeaning.h"

namespace perilymph::electrode {

/// Every key of an array's file, "table.key", but for `source` and `confidence`, which every table has.
/// Default and allowed values are where a key is read.
const FieldMeanings& arrayKeyTable();

}  // namespace perilymph::electrode
