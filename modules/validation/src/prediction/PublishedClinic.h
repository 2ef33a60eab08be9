// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What clinics publish, as the clinical table compares it.

#include <string>
#include <vector>

#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/validation/Prediction.h"
#include "prediction/ClinicalRule.h"

namespace perilymph::validation {

/// A published count.
struct ClinicalRate {
  std::string quantity;  ///< "complete insertion" or "translocation".
  std::string array;     ///< Shipped name, "all", or "none" if none of them is inserted.
  std::string kind;      ///< Kind of arrays.
  std::string source, confidence;
  int count = 0, of = 1;

  /// Name of its row.
  std::string rowName() const;
  /// Whether an insertion counts for it.
  bool counts(const analysis::ClinicalInsertion& insertion) const;
};

/// The shipped counts: resources/clinical/rates.toml.
Result<std::vector<ClinicalRate>> clinicalRates();

/// One array's depths at all centers.
struct PublishedArray {
  std::string array;
  std::vector<ClinicalAngle> centers;

  /// The samples, in degrees.
  std::vector<PublishedSample> samples() const;
};

/// The shipped depths, by array in the order of their file.
Result<std::vector<PublishedArray>> publishedArrays();

/// Whether all contacts are inside; of an insertion without contacts whether it was finished.
bool isComplete(const analysis::ClinicalInsertion& insertion);

}  // namespace perilymph::validation
