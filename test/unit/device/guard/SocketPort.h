// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A device at the other end of a socket: each handle is a connection, each report a message. A
// process that dies closes its handles, as with a hidraw node.

#include <string>

#include "hid/HidPort.h"

namespace perilymph::test {

/// Each connection begins with a message of one letter: 'r' reports, 'g' guards.
std::unique_ptr<device::HidPort> socketPort(std::string name);

/// A connection to an abstract socket; -1 if there is no listener.
int connectTo(const std::string& name, char letter) noexcept;
/// A listening socket; -1 if it cannot be created.
int listenAs(const std::string& name) noexcept;

}  // namespace perilymph::test
