#pragma once

// One visitor's insertion, as far as the board wants to know it.

#include <QString>

#include "perilymph/analysis/Reference.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// Follows an insertion through its snapshots: the greatest force of those shown, how deep it came,
/// how often it turned back.
class KioskTurn {
public:
  /// Adds what one picture says.
  void follow(const haptics::TickOutput& now);

  double peakForce() const { return peakForce_; }          ///< [N]
  double deepestTravel() const { return deepestTravel_; }  ///< [m]
  double duration() const { return duration_; }            ///< Since the array began to move [s].
  int reversals() const { return reversals_; }

private:
  double peakForce_ = 0.0;
  double deepestTravel_ = 0.0;
  double duration_ = 0.0;
  int reversals_ = 0;
  double turning_ = 0.0;  ///< Where the travel last turned, or its farthest since [m].
  bool isAdvancing_ = true;
};

/// The peak in words, beside the range of peaks measured in patients: "below the peaks measured in
/// patients". A comparison, no judgment of safety.
QString peakText(double peak_N, const Result<analysis::Reference>& inVivo);

/// The range those words speak of and who measured it; empty if it could not be read.
QString peakSource(const Result<analysis::Reference>& inVivo);

}  // namespace perilymph::gui
