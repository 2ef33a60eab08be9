// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The messages of the Haply Inverse Service, version 3.5 (docs.haply.co, "WebSocket Protocol", "Control
// Commands", "Basis Permutation", "Mount & Workspace Transforms"; read in November 2026).

#include <optional>
#include <string>

#include "DeviceLink.h"

namespace perilymph::haply {

using plugin::Sample;
using plugin::Vector;

/// The devices of the service's first message.
struct Inventory {
  std::string inverse3;  ///< Identifier of the first Inverse3; empty if there is none.
  bool hasGrip = false;  ///< A VerseGrip, with or without wires, whose button grasps.
};

/// None if the message is no such JSON.
std::optional<Inventory> inventoryOf(const std::string& message);

/// The command to render a force [N, D]. The service forgets it when no further one comes.
std::string forceMessage(const std::string& inverse3, const Vector& force_D);
/// The first command: names the session, puts the origin to the center of the workspace, no force.
std::string openingMessage(const std::string& inverse3);
/// Asks for the state without a force.
std::string probeMessage(const std::string& inverse3);

/// The state of a device. None if the message does not contain it: the device is gone.
std::optional<Sample> sampleOf(const std::string& message, const std::string& inverse3);

}  // namespace perilymph::haply
