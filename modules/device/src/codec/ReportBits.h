// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Numbers of 1 to 32 bits in a report. HID packs them without gaps, least significant bit first.

#include <cstdint>
#include <span>

#include "codec/ReportDescriptor.h"

namespace perilymph::device {

/// The number in a slot of a report; `report` excludes the report number (first byte). Bits beyond
/// the report's end read 0. Real-time safe.
std::int64_t numberAt(std::span<const std::uint8_t> report, const ReportSlot& slot) noexcept;

/// Writes a number into a slot, clamped to the range of its bits; the rest of the report is
/// unchanged, and nothing is written beyond its end. Real-time safe.
void putNumber(std::span<std::uint8_t> report, const ReportSlot& slot,
               std::int64_t number) noexcept;

}  // namespace perilymph::device
