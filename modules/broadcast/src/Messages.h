// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// OpenIGTLink messages as bytes.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
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
inline constexpr const char* forceVectorName = "PerilymphForceXYZ";
inline constexpr const char* readoutName = "PerilymphReadout";
inline constexpr const char* toPatientName = "PerilymphToPatient";
inline constexpr const char* scalaName = "PerilymphScala";
inline constexpr const char* vestibuliName = "PerilymphVestibuli";
inline constexpr const char* arrayName = "PerilymphArray";
inline constexpr const char* ctName = "PerilymphCT";
inline constexpr const char* programName = "Perilymph";

/// Messages of one moment with the same time stamp, in this order: TRANSFORM of tip and tweezers, POINT of
/// the contacts [mm], SENSOR of the force (x, y, z, axial) [N], TRANSFORM whose translation is the
/// force (x, y, z) [N], STRING of readoutText(). Only the last one if nothing is shown.
Bytes frameMessages(const BroadcastFrame& frame);
/// Lines "name=value" with the names of the table of an insertion (session/Csv.h), the frame:
/// "coordinates=cochlea", and "patient=known" or "patient=unknown": without its patient, a cochlea is
/// not to be shown over a CT that was received before. Only the last of them if nothing is shown.
std::string readoutText(const BroadcastFrame& frame);
/// TRANSFORM from the frame that is sent to the patient's RAS [mm].
Bytes placementMessage(const Placement& placement);
/// POLYDATA of a surface [mm], with the name of its device; in RAS if a placement is given.
Bytes surfaceMessage(const anatomy::Surface& surface, const char* name,
                     const std::optional<Placement>& patient = std::nullopt);
/// IMAGE of a volume of at most 65,535 voxels along each axis.
///
/// @param placed_SI  Index to the frame that is sent [mm].
Bytes imageMessage(const ct::CtVolume& volume, const Eigen::Matrix4d& placed_SI);
/// CAPABILITY: the types that are sent.
Bytes capabilityMessage();
/// STATUS of a device that a client asked for.
///
/// @param code  As the protocol numbers them: 1 OK, 4 not found.
Bytes statusMessage(const std::string& device, std::uint16_t code, const std::string& sentence);

}  // namespace perilymph::broadcast
