// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// OpenIGTLink messages as bytes.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/broadcast/BroadcastFrame.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::broadcast {

using Bytes = std::vector<std::uint8_t>;

/// Names of the devices, at most 20 characters.
inline constexpr const char* tipName = "PerilymphTip";
inline constexpr const char* tweezersName = "PerilymphTweezers";
inline constexpr const char* contactsName = "PerilymphContacts";
inline constexpr const char* forceName = "PerilymphForce";
inline constexpr const char* scalaName = "PerilymphScala";
inline constexpr const char* arrayName = "PerilymphArray";
inline constexpr const char* ctName = "PerilymphCT";

/// TRANSFORM of tip and tweezers, POINT of the contacts [mm], SENSOR of the force (x, y, z, axial)
/// [N], in this order and with the same time stamp.
Bytes frameMessages(const BroadcastFrame& frame);
/// POLYDATA of a surface [mm], with the name of its device.
Bytes surfaceMessage(const anatomy::Surface& surface, const char* name);
/// IMAGE of a volume of at most 65,535 voxels along each axis.
///
/// @param placed_WI  Index to W [mm].
Bytes imageMessage(const ct::CtVolume& volume, const Eigen::Matrix4d& placed_WI);
/// CAPABILITY: the types that are sent.
Bytes capabilityMessage();

}  // namespace perilymph::broadcast
