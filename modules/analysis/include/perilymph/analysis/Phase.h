// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Phases of an insertion, named as in the published experiment.

#include <cstdint>

#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::analysis {

/// Derived from depth, angle and contacts; not part of the engine's state.
enum class Phase : std::uint32_t {
  outside,    ///< The tip is before the opening.
  opening,    ///< The tip is inside; nothing touches the wall beyond the lead-in.
  outerWall,  ///< The array touches and slides along the outer wall.
  basalTurn,  ///< The tip is at or beyond basalTurnAngle.
  full,       ///< The stop travel is reached, or the insertion is finished without an early end.
};

/// Angle from which the tip is in the basal turn. The published experiment's force peaks at 10.6 mm
/// of travel; with the tip initially 2 mm inside and a lead-in of 1 mm that is 11.6 mm past the
/// round window, where a path 0.4 mm off the outer wall of the measured mean scala tympani is at
/// 160 degrees (Schurzig and Froehlich's model); the initial depth of 1 to 3 mm spreads this over
/// 140 to 180 degrees.
inline constexpr Angle basalTurnAngle = degrees(140);

/// The phase of a tick, given the stop travel of the insertion.
Phase phaseOf(const haptics::TickOutput& now, Length stopTravel) noexcept;

/// "outside", "opening", "outer wall", "basal turn", "full".
const char* phaseName(Phase phase) noexcept;

}  // namespace perilymph::analysis
