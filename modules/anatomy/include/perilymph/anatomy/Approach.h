// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The direction of an insertion at the opening: as a scenario has it, and as angles to the basal turn.

#include <Eigen/Core>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Direction of an insertion against the axis of the opening: into the cochlea along -E.z, tilted
/// toward E.y and turned toward E.x. A scenario's `approach_tilt_deg` and `approach_turn_deg`.
struct Approach {
  Angle tilt, turn;
};

/// Largest tilt and turn to either side that a scenario has.
inline constexpr double steepestApproach_deg = 30.0;

/// Unit direction in which the array is pushed, into the cochlea.
Eigen::Vector3d directionOf(const Approach& approach, const Entry& entry) noexcept;

/// The approach with a direction into the cochlea, of any length but 0.
Approach approachAlong(const Eigen::Vector3d& into_W, const Entry& entry) noexcept;

/// The approach within the limits of a scenario that is nearest to one in tilt and in turn, both to a
/// hundredth of a degree.
Approach withinLimits(const Approach& approach) noexcept;

/// Angles of an insertion to the basal turn; both are 0 along the tangent of the scala tympani's center
/// line at the round window.
///
/// The plane of the basal turn is perpendicular to the modiolar axis (W's z). With the unit direction d
/// into the cochlea, the tangent t, and their parts d' and t' in that plane:
///
///     in the plane:  angle from t' to d', positive toward the lateral wall
///     out of it:     asin(d_z) - asin(t_z), positive toward the basilar membrane
///
/// Insertions along tangents of the center line of the basal turn as the ideal, and the deviations from
/// them in the basilar plane and out of it: Wimmer et al. 2014, Biomed Res Int 596498, as the
/// supplement of a later study with the same planning describes them (angles epsilon and delta).
struct BasalTurnAngles {
  Angle inPlane, outOfPlane;
};

BasalTurnAngles anglesToBasalTurn(const Approach& approach, const Entry& entry) noexcept;

/// The approach with these angles to the basal turn.
Approach approachAt(const BasalTurnAngles& angles, const Entry& entry) noexcept;

}  // namespace perilymph::anatomy
