// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace perilymph::archive {

/// The IPv4 addresses of this machine's networks that are up, without the loopback: what an archive's
/// administrator enters for this workstation. Asks the system, and no other machine.
std::vector<std::string> ownAddresses();

}  // namespace perilymph::archive
