// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A handle to a real HID device: a Linux hidraw node, through hidapi.

#include <filesystem>
#include <memory>

#include "hid/Transport.h"

namespace perilymph::device {

/// Whether the reports of a device begin with their number (ReportDescriptor::isNumbered).
enum class ReportNumbers : std::uint8_t { none, inFront };

/// Opens a node such as /dev/hidraw0. Each call makes an independent handle: a reading and a
/// writing handle share nothing, because hidapi does not lock its error texts. Reading does not
/// allocate until the device is gone.
Result<std::unique_ptr<Transport>> openHidTransport(const std::filesystem::path& node,
                                                    ReportNumbers numbers);

}  // namespace perilymph::device
