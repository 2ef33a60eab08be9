// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An insertion with a closed-form solution: a stiff rod against a stiff flat wall, so that the
// coupling is the only spring.

#include <memory>

#include "perilymph/haptics/InsertionEngine.h"

namespace perilymph::hidstack {

/// Ratio of the force at the handle to that on the array: an array that is pushed with 2 N is jammed,
/// and a handle that was silent comes back with more.
inline constexpr double forceScale = 4.0;

/// Stiffness of the coupling at the handle [N/m]: that of the wall in the published simulator.
inline constexpr double couplingStiffness = 441.0;

/// Distance that the hand moves from grasping until the rod touches the wall [m].
inline constexpr double freeWay = 1e-3;

/// The model of this scene.
std::shared_ptr<const mechanics::InsertionModel> flatWallModel();

/// The engine of this scene, at 1 kHz, without friction. In balance with a push F the hand stands
/// F / K beyond the free way, K the coupling's stiffness.
std::unique_ptr<haptics::InsertionEngine> flatWallEngine(double samplePeriod);

}  // namespace perilymph::hidstack
