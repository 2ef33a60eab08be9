#pragma once

// What the program and the guard of its device tell each other: files, reports, a pulse. Nothing in
// here allocates or throws.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace perilymph::device::guard {

/// The guard's files, as it finds them when it starts.
enum File : int {
  wire = 0,    ///< A pipe from the program: the script, then goodbye. Its end is the program's end.
  device = 3,  ///< The device's node.
  pulse = 4,   ///< Memory shared with the program: a Pulse.
};

/// The last byte of a program that leaves its device in order.
inline constexpr std::uint8_t goodbye = 'b';

/// How the program is doing, for as long as it can tell.
struct Pulse {
  std::atomic<std::uint64_t> forces{0};     ///< Reports the device took so far.
  std::atomic<std::uint32_t> isPushing{0};  ///< The last of them were not those of no force.
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free &&
              std::atomic<std::uint32_t>::is_always_lock_free);

/// Bytes that stand before everything else: a guard of another version goes at once.
inline constexpr std::uint8_t version = 1;

/// One report of the script.
struct Line {
  bool isFeature = false;
  std::span<const std::uint8_t> bytes;  ///< The number first, 0 if it has none.
};

/// The reports that the guard sends. As bytes:
///
///     version, patience [ms], reports of no force, reports that switch off
///     per report: 0 output or 1 feature, size in two bytes (little-endian), bytes
class Script {
public:
  static constexpr std::size_t capacity = 16384;  ///< Fits into a pipe in one piece.
  static constexpr std::size_t maxLines = 32;
  static constexpr std::size_t head = 6;  ///< version, patience, two counts, size of what follows

  /// @param patience_ms  After which a force that nobody renews is taken back, 0 to 255.
  explicit Script(std::uint8_t patience_ms = 0) noexcept;

  /// False when the script is full. All lines of no force come first.
  bool addNoForce(const Line& line) noexcept;
  bool addSwitchOff(const Line& line) noexcept;

  /// Everything, for the pipe.
  std::span<const std::uint8_t> bytes() const noexcept { return {bytes_.data(), size_}; }
  /// Size of what follows a head that was read; 0 if the head is invalid.
  static std::size_t sizeBehind(std::span<const std::uint8_t> headBytes) noexcept;
  /// Takes what was read from the pipe. False if it makes no sense.
  bool take(std::span<const std::uint8_t> bytes) noexcept;

  std::uint8_t patience_ms() const noexcept { return bytes_[1]; }
  std::size_t noForceLines() const noexcept { return bytes_[2]; }
  std::size_t lines() const noexcept { return noForceLines() + bytes_[3]; }
  /// The lines: the one without force first, then those that switch off.
  Line line(std::size_t index) const noexcept;

private:
  bool add(const Line& line) noexcept;

  std::array<std::uint8_t, capacity> bytes_{};
  std::size_t size_ = head;
};

}  // namespace perilymph::device::guard
