#pragma once

// A handle on a real HID device: a hidraw node of Linux, through hidapi.

#include <filesystem>
#include <memory>

#include "perilymph/device/Transport.h"

namespace perilymph::device {

/// Whether the reports of a device begin with their number (ReportDescriptor::isNumbered).
enum class ReportNumbers : std::uint8_t { none, inFront };

/// Opens a node such as /dev/hidraw0. Each call makes a handle of its own: one that is read and one
/// that is written never share anything, because hidapi does not lock its error texts. Reading
/// allocates nothing until the device is gone.
Result<std::unique_ptr<Transport>> openHidTransport(const std::filesystem::path& node,
                                                    ReportNumbers numbers);

}  // namespace perilymph::device
