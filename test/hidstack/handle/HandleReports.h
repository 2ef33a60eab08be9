// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reports of the virtual handle.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace perilymph::hidstack {

/// Input report, sent a thousand times a second.
struct InputReport {
  std::uint16_t sequence = 0;           ///< Incremented with each report, with wraparound.
  std::array<std::int32_t, 3> place{};  ///< x right, y up, z toward the user [quanta of place].
  std::uint8_t buttons = 0;             ///< Bit 0: the grasp button.
};

/// Output report with the force.
struct OutputReport {
  std::array<std::int16_t, 3> force{};  ///< In the same frame [quanta of force].
};

inline constexpr double placeQuantum = 1e-7;  ///< [m]
inline constexpr double forceQuantum = 1e-4;  ///< [N]
inline constexpr double maxForce = 3.2;       ///< [N]

inline constexpr std::uint16_t vendor = 0x1209;  ///< pid.codes, whose product 1 is for tests.
inline constexpr std::uint16_t product = 0x0001;
inline constexpr std::uint8_t inputNumber = 1;
inline constexpr std::uint8_t outputNumber = 2;
inline constexpr std::size_t inputSize = 1 + 2 + 12 + 1;  ///< Including the report number [bytes].
inline constexpr std::size_t outputSize = 1 + 6;

/// The HID report descriptor of these reports.
std::span<const std::uint8_t> reportDescriptor();

std::array<std::uint8_t, inputSize> encode(const InputReport& report);
std::array<std::uint8_t, outputSize> encode(const OutputReport& report);
/// Empty if the bytes are not such a report.
std::optional<InputReport> decodeInput(std::span<const std::uint8_t> bytes);
std::optional<OutputReport> decodeOutput(std::span<const std::uint8_t> bytes);

}  // namespace perilymph::hidstack
