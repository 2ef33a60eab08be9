// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The approach of a scenario.

#include <cmath>

#include "perilymph/anatomy/Approach.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

inline anatomy::Approach approachOf(const session::Scenario& scenario)
{
  return {scenario.approachTilt(), scenario.approachTurn()};
}

/// Whether two approaches are written alike in scenarios, which have hundredths of a degree.
inline bool areSame(const anatomy::Approach& one, const anatomy::Approach& other)
{
  constexpr double least_deg = 1e-6;
  return std::fabs(inDegrees(one.tilt - other.tilt)) < least_deg &&
         std::fabs(inDegrees(one.turn - other.turn)) < least_deg;
}

/// Whether it is along the axis of the opening.
inline bool isAlongAxis(const anatomy::Approach& approach) { return areSame(approach, {}); }

}  // namespace perilymph::gui
