// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Columns of the tables of a study's report.

#include "perilymph/foundation/FieldMeaning.h"

namespace perilymph::study {

/// Columns of groups.csv, differences.csv and trends.csv.
const FieldMeanings& summaryGroupColumns();
const FieldMeanings& summaryDifferenceColumns();
const FieldMeanings& summaryTrendColumns();

}  // namespace perilymph::study
