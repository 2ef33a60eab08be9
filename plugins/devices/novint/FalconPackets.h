// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The packets of the Falcon's firmware, as libnifalcon documents them (FalconFirmwareNovintSDK.h):
// 16 bytes to the device are answered by 16 bytes. Both begin with '<' and end with '>'; the others are
// numbers of four bits, sent as letters from 'A', the lowest first.
//
//   to the device    three motors (4 letters each, signed), lights and homing (1), unused (1)
//   from the device  three encoders (4 letters each, signed), buttons and homing (1), unused (1)
//
// The header of libnifalcon names bit 4 for the homing mode; its code, which devices obey, sets bit 0.

#include <array>
#include <cstdint>
#include <optional>

namespace perilymph::novint {

using Packet = std::array<std::uint8_t, 16>;
using Counts = std::array<int, 3>;  // top, right, left arm, seen from the front

inline constexpr int greenLight = 2, blueLight = 4, redLight = 8;
/// The largest value of a motor that libnifalcon sends.
inline constexpr int maxMotorCount = 4096;

/// @param lights  A sum of lights. The homing mode is always on: without it positions are not valid.
inline Packet encoded(const Counts& motors, int lights) noexcept
{
  constexpr int homing = 1;
  Packet packet;
  packet.fill('A');
  packet.front() = '<';
  packet.back() = '>';
  for (std::size_t i = 0; i < 3; ++i) {
    const auto bits = static_cast<std::uint16_t>(motors[i]);
    for (std::size_t k = 0; k < 4; ++k)
      packet[1 + 4 * i + k] = static_cast<std::uint8_t>('A' + ((bits >> (4 * k)) & 15));
  }
  packet[13] = static_cast<std::uint8_t>('A' + (lights | homing));
  return packet;
}

struct FalconState {
  Counts encoders{};
  /// Right (+), forward, center, left (-) of the usual grip.
  std::uint32_t buttons = 0;
  /// All three encoders passed their marks: the counts begin at the home position.
  bool isHomed = false;
};

/// None if the packet is damaged.
inline std::optional<FalconState> decoded(const Packet& packet) noexcept
{
  if (packet.front() != '<' || packet.back() != '>') return std::nullopt;
  FalconState state;
  for (std::size_t i = 0; i < 3; ++i) {
    std::uint16_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const int nibble = packet[1 + 4 * i + k] - 'A';
      if (nibble < 0 || nibble > 15) return std::nullopt;
      bits = static_cast<std::uint16_t>(bits | (nibble << (4 * k)));
    }
    state.encoders[i] = static_cast<std::int16_t>(bits);
  }
  const int status = packet[13] - 'A';
  if (status < 0 || status > 127) return std::nullopt;
  state.buttons = static_cast<std::uint32_t>(status & 15);
  state.isHomed = (status >> 4) == 7;
  return state;
}

}  // namespace perilymph::novint
