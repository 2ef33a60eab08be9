// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Statistics of one visitor's insertion, for the list.

#include <QString>

#include "perilymph/analysis/Reference.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// Tracks an insertion through its snapshots: maximum of the displayed forces, maximum depth,
/// number of reversals.
class VisitorSession {
public:
  /// Adds one snapshot.
  void follow(const haptics::Snapshot& snapshot);

  double peakForce() const { return peakForce_; }          ///< [N]
  double deepestTravel() const { return deepestTravel_; }  ///< [m]
  double duration() const { return duration_; }            ///< Since the first motion [s].
  int reversals() const { return reversals_; }

private:
  double peakForce_ = 0.0;
  double deepestTravel_ = 0.0;
  double duration_ = 0.0;
  int reversals_ = 0;
  double turning_ = 0.0;  ///< Travel at the last reversal, or the extreme since then [m].
  bool isAdvancing_ = true;
};

/// Compares the peak with the range of peaks measured in patients: "below the peaks measured in
/// patients". A comparison, not a statement on safety.
QString peakText(double peak_N, const Result<analysis::PrintedRange>& peaks);

/// That range and its source; empty if it could not be read.
QString peakSource(const Result<analysis::PrintedRange>& peaks);

}  // namespace perilymph::gui
