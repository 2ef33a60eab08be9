#pragma once

// Where in the cochlea an insertion is, in the words of the published experiment.

#include <cstdint>

#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::analysis {

/// Derived from depth, angle and contacts; not a state of the program.
enum class Phase : std::uint32_t {
  outside,    ///< The tip is before the opening.
  opening,    ///< The tip is inside; nothing touches the wall beyond the lead-in yet.
  outerWall,  ///< The array touches and slides along the outer wall.
  basalTurn,  ///< The tip is at basalTurnAngle or beyond.
  full,       ///< The stop travel is reached, or the insertion is finished.
};

/// From here on the tip rounds the basal turn. The published experiment's force peaks at 10.6 mm of
/// travel; with the tip 2 mm inside at the start and a lead-in of 1 mm that is 11.6 mm past the
/// round window, where a path 0.4 mm off the outer wall of the measured mean scala tympani is at
/// 160 degrees (Schurzig and Froehlich's model); the start of 1 to 3 mm spreads this over 140 to
/// 180 degrees.
inline constexpr Angle basalTurnAngle = degrees(140);

/// The phase of a tick of an insertion that stops at a travel.
Phase phaseOf(const haptics::TickOutput& now, Length stopTravel) noexcept;

/// "outside", "opening", "outer wall", "basal turn", "full".
const char* phaseName(Phase phase) noexcept;

}  // namespace perilymph::analysis
