// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Outcomes as files: JSON for programs and for the patient's record, CSV for whoever programs the processor.

#include <optional>
#include <string>

#include "perilymph/outcome/FoundArray.h"
#include "perilymph/outcome/Surgery.h"

namespace perilymph::outcome {

/// A found array with what the surgeon knows and the plan it is compared with.
struct OutcomeContent {
  FoundArray found;
  Surgery surgery;
  std::string plan;    ///< The plan's number (fingerprint); empty: none.
  std::string series;  ///< SHA-256 of the CT series after surgery; empty if unknown.
  /// Days from the CT to the day, in Greenwich, on which the outcome was saved in the patient's record, -1 to
  /// 36,500: the clinic's day may be ahead. Absent where nobody stated the CT's day, and in other files.
  std::optional<int> ctAge_days = {};
};

/// JSON text, `format` 1. Keys are those of the guide's reference; no name, no date.
std::string outcomeJson(const OutcomeContent& content);
/// Reads it again; refuses with a sentence what does not hold.
/// @param name  Of the outcome, for sentences.
Result<OutcomeContent> outcomeIn(const std::string& text, const Sentence& name);

/// One row a contact.
std::string outcomeCsv(const FoundArray& found);
/// `column, unit, meaning`: a row for each column, in their order.
std::string outcomeDictionaryCsv();
/// 3D Slicer's markups of the contacts, in LPS.
std::string outcomeMarkups(const FoundArray& found);

}  // namespace perilymph::outcome
