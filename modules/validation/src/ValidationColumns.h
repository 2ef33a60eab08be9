// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Columns of the tables of `validate`, `calibrate` and `predict`.

#include "perilymph/foundation/FieldMeaning.h"

namespace perilymph::validation {

/// Columns of profileCsv() and differenceCsv().
const FieldMeanings& forceColumns();
/// Columns of priorSummaryCsv() and priorCsv().
const FieldMeanings& priorSummaryColumns();
const FieldMeanings& priorColumns();
/// Columns of benchFrictionCsv(), benchPredictedCsv() and benchScoresCsv().
const FieldMeanings& benchFrictionColumns();
const FieldMeanings& benchPredictedColumns();
const FieldMeanings& benchScoreColumns();
/// Columns of predictionCsv(), clinicalRowsCsv() and clinicalInsertionsCsv().
const FieldMeanings& predictionColumns();
const FieldMeanings& clinicalRowColumns();
const FieldMeanings& clinicalInsertionColumns();

}  // namespace perilymph::validation
