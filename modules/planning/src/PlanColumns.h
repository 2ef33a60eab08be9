// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Columns of the tables of a plan; those of contacts.csv are beside its writer (ContactsCsv.h).

#include <array>

#include "perilymph/analysis/ClinicalReports.h"
#include "perilymph/foundation/FieldMeaning.h"

namespace perilymph::planning {

/// What clinics report, in the order of the columns of arraysCsv().
inline constexpr std::array besideArrays = {
    analysis::ReportedQuantity::angle,         analysis::ReportedQuantity::complete,
    analysis::ReportedQuantity::translocation, analysis::ReportedQuantity::foldOver,
    analysis::ReportedQuantity::peakForce,     analysis::ReportedQuantity::endForce};

/// Columns of arraysCsv() and differencesCsv().
const FieldMeanings& planArrayColumns();
const FieldMeanings& planDifferenceColumns();

}  // namespace perilymph::planning
