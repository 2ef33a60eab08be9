// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Position of each electrode contact in the cochlea, as in a clinical report.

#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::analysis {

/// Position of one contact. If it is not inserted, only its number and depth are set.
struct ContactPosition {
  int number = 0;  ///< 1 at the tip.
  bool isInserted = false;
  bool isAbove = false;       ///< Above the cochlear partition, in the scala vestibuli.
  Length depth;               ///< Along the array past the opening; negative outside.
  Angle angle;                ///< From the center of the round window, full turns included.
  double coverage = 0.0;      ///< Part of the organ of Corti basal to it, 0 to 1.
  double frequency_Hz = 0.0;  ///< Greenwood's frequency at that place.
  /// From the center line of the array to the inner wall, toward the modiolar axis; negative if no
  /// lumen is in that direction, and above the partition.
  Length toModiolus;
};

/// The contacts from the tip to the base. Takes some milliseconds; not real-time safe. A snapshot
/// with fewer than 2 nodes results in none.
std::vector<ContactPosition> contactPositions(const anatomy::ScalaTympani& scala,
                                              const electrode::ArrayDesign& array,
                                              const haptics::Snapshot& now);

/// Angular insertion depth, as clinics and trials report it: the angle of the most apical contact from
/// the center of the round window; 0 while none is inserted. The tip lies deeper by some degrees: its
/// angle is the tip angle (haptics::TickOutput::angularDepth).
Angle angularInsertionDepth(const std::vector<ContactPosition>& contacts);
/// The same in about 0.1 ms, for what is shown while an array moves.
Angle angularInsertionDepth(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array,
                            const haptics::Snapshot& now);

/// Part of the organ of Corti basal to the most apical inserted contact, 0 to 1.
double cochlearCoverage(const std::vector<ContactPosition>& contacts);

}  // namespace perilymph::analysis
