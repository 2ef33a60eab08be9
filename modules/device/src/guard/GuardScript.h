// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Communication between the program and its device guard: descriptors, reports, a pulse. Nothing
// here allocates or throws.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace perilymph::device::guard {

/// The guard's file descriptors at its start.
enum File : int {
  wire = 0,    ///< A pipe from the program: the script, then goodbye. It closes when the program
               ///< ends.
  device = 3,  ///< The device's node.
  pulse = 4,   ///< Memory shared with the program: a Pulse.
};

/// Last byte sent by a program that ends regularly.
inline constexpr std::uint8_t goodbye = 'b';

/// Activity of the program, in shared memory.
struct Pulse {
  std::atomic<std::uint64_t> forces{0};     ///< Number of reports accepted by the device.
  std::atomic<std::uint32_t> isPushing{0};  ///< The last reports rendered a force.
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free &&
              std::atomic<std::uint32_t>::is_always_lock_free);

/// Version at the start of the script: a guard of another version exits at once.
inline constexpr std::uint8_t version = 1;

/// One report of the script.
struct Line {
  bool isFeature = false;
  std::span<const std::uint8_t> bytes;  ///< Report number first, 0 if unnumbered.
};

/// The reports that the guard sends. Encoded as:
///
///     version, patience [ms], reports of no force, reports that switch off
///     per report: 0 output or 1 feature, size in two bytes (little-endian), bytes
class Script {
public:
  static constexpr std::size_t capacity = 16384;  ///< Fits into a pipe in one write.
  static constexpr std::size_t maxLines = 32;
  static constexpr std::size_t head = 6;  ///< version, patience, two counts, size of the rest

  /// @param patience_ms  Time after which a force that is not renewed is removed, 0 to 255.
  explicit Script(std::uint8_t patience_ms = 0) noexcept;

  /// False if the script is full. All lines of no force must come first.
  bool addNoForce(const Line& line) noexcept;
  bool addSwitchOff(const Line& line) noexcept;

  /// The encoded script.
  std::span<const std::uint8_t> bytes() const noexcept { return {bytes_.data(), size_}; }
  /// Size of the rest after a header; 0 if the header is invalid.
  static std::size_t sizeBehind(std::span<const std::uint8_t> headBytes) noexcept;
  /// Decodes what was read from the pipe. False if it is invalid.
  bool take(std::span<const std::uint8_t> bytes) noexcept;

  std::uint8_t patience_ms() const noexcept { return bytes_[1]; }
  std::size_t noForceLines() const noexcept { return bytes_[2]; }
  std::size_t lines() const noexcept { return noForceLines() + bytes_[3]; }
  /// The lines: first those of no force, then those that switch off.
  Line line(std::size_t index) const noexcept;

private:
  bool add(const Line& line) noexcept;

  std::array<std::uint8_t, capacity> bytes_{};
  std::size_t size_ = head;
};

}  // namespace perilymph::device::guard
