// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What it takes to push an array into a lumen that is narrower than the array.

#include "contact/Crossing.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::mechanics {

/// Radius of the largest circle in the first section of a scala tympani, across the axis of its lead-in
/// [m].
double mouthRadiusOf(const anatomy::ScalaTympani& scala);

/// Adds the resistance of the mouth to an array that is thicker than it: the energy per length that the
/// wall will hold in the array's lining and silicone, at the place where the array enters. Without it that
/// energy would come from nothing, and a widening duct would push the array on with it. Smooth along
/// the array, whatever its nodes.
void addMouthForces(const InsertionModel& model, const Crossing& crossing,
                    std::vector<Eigen::Vector3d>& force_W) noexcept;

}  // namespace perilymph::mechanics
