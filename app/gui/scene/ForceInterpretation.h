// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Interpretation of forces by published thresholds, with sources. No force is ever called safe.

#include <QString>
#include <optional>

#include "perilymph/analysis/Reference.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// Published force thresholds.
struct ForceThresholds {
  std::optional<Force> felt;                      ///< Median force that surgeons perceive.
  std::optional<analysis::PrintedRange> peaks;    ///< On the hand, in patients.
  std::optional<analysis::PrintedRange> rupture;  ///< Rupture of the partition, normal to it.

  /// Thresholds of the shipped references; a missing one is omitted.
  static ForceThresholds shipped();
};

/// Text of an interpretation, and whether it is highlighted.
struct ForceMeaning {
  QString text;
  bool isBeyond = false;
};

/// Interpretation of a force on the hand.
ForceMeaning meaningOnHand(Force force, const ForceThresholds& known);
/// Interpretation of the sum of the forces normal to the partition.
ForceMeaning meaningOnPartition(Force force, const ForceThresholds& known);
/// Says where the partition ruptured in this insertion, at which force, and whether the array went
/// through.
ForceMeaning meaningOfRupture(const haptics::Translocation& rupture);

}  // namespace perilymph::gui
