// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a patient's measures mean: duct length, and how far an array reaches.

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// The measures by which a clinician chooses an array, those of the cochlea that the mechanics use.
struct CochleaMeasures {
  // Keys of the measures.
  static constexpr auto ductLength = "duct_length_mm";
  static constexpr auto angularDepth = "angular_insertion_depth_deg";

  std::vector<analysis::Measure> measures;
  std::vector<double> bands;  ///< Their errors; empty if nothing was measured in a patient.
};

/// Computes measures and keeps them, because their errors take three cochleae more. Any thread.
class MeasureStore {
public:
  static constexpr std::size_t capacity = 64;

  /// @return An error if the cochlea cannot be built.
  Result<CochleaMeasures> of(const anatomy::Cochlea& cochlea, const electrode::ArrayDesign& array);

  /// What the measures depend on, as text.
  static std::string keyOf(const anatomy::Cochlea& cochlea, const electrode::ArrayDesign& array);

private:
  std::mutex mutex_;
  std::map<std::string, CochleaMeasures> kept_;
};

}  // namespace perilymph::gui
