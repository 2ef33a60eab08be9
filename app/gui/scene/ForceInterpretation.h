#pragma once

// What a force means, in words beside the number: thresholds that others measured, with sources.
// Nothing is ever called safe.

#include <QString>
#include <optional>

#include "perilymph/analysis/Reference.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

/// What is known about forces, as printed.
struct ForceThresholds {
  /// Median force that ten otologic surgeons feel: Kratchman 2016, Audiol Neurotol 21:244.
  Force felt = millinewtons(20.4);
  std::optional<analysis::PrintedRange> peaks;    ///< On the hand, in patients.
  std::optional<analysis::PrintedRange> rupture;  ///< Rupture of the partition, normal to it.

  /// With the shipped references; a missing one leaves its threshold out.
  static ForceThresholds shipped();
};

/// A sentence's worth of meaning, and whether it stands out.
struct ForceMeaning {
  QString text;
  bool isBeyond = false;
};

/// Meaning of a force on the hand.
ForceMeaning meaningOnHand(Force force, const ForceThresholds& known);
/// Meaning of the sum of the forces normal to the partition.
ForceMeaning meaningOnPartition(Force force, const ForceThresholds& known);

}  // namespace perilymph::gui
