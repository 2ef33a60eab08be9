// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Columns of the tables that compare recordings and of the table of sections of a cochlea.

#include "perilymph/foundation/FieldMeaning.h"

namespace perilymph::analysis {

/// Columns of curvesCsv().
const FieldMeanings& curveColumns();
/// Columns of comparisonCsv(), eventsCsv(), groupsCsv() and differencesCsv().
const FieldMeanings& comparisonColumns();
const FieldMeanings& eventColumns();
const FieldMeanings& groupColumns();
const FieldMeanings& differenceColumns();
/// Columns of sectionsCsv().
const FieldMeanings& sectionMeanings();

}  // namespace perilymph::analysis
