// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Connects the two threads of a device plug-in: the one of the program, which must not wait, and one
// that exchanges forces and samples with the device and may wait for it.

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <ctime>

#include "perilymph/device/PluginApi.h"

namespace perilymph::plugin {

using Vector = std::array<double, 3>;

/// Monotonic time [ns].
inline std::int64_t now() noexcept
{
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// The newest value of one thread for one other, without a lock: three slots, one of which changes
/// hands. Neither thread waits.
template <class T>
class Newest {
public:
  void put(const T& value) noexcept
  {
    slots_[written_] = value;
    written_ = spare_.exchange(written_ | fresh) & slot;
  }
  const T& get() noexcept
  {
    if ((spare_.load() & fresh) != 0) read_ = spare_.exchange(read_) & slot;
    return slots_[read_];
  }

private:
  static constexpr unsigned fresh = 4, slot = 3;
  std::array<T, 3> slots_{};
  unsigned written_ = 0, read_ = 1;
  std::atomic<unsigned> spare_{2};
};

/// What a device measured.
struct Sample {
  Vector position{};                             ///< The handle's, in D [m].
  std::array<double, 4> rotation{1.0, 0, 0, 0};  ///< Handle to D: unit quaternion w, x, y, z.
  std::uint32_t buttons = 0;                     ///< Bit 0: the dead-man's button.
};

/// The exchange of forces and samples between the two threads; each calls the functions under its name.
class DeviceLink {
public:
  /// @param maxForce  Published limit of the device [N].
  explicit DeviceLink(double maxForce) noexcept : maxForce_(maxForce) {}

  // --- The device's thread.

  /// The force to render now [N, D]: that of the program, limited in magnitude. Zero if the device
  /// is lost or does not answer, or if the program wrote none for `patience`.
  Vector force() noexcept
  {
    const Command& command = commands_.get();
    taken_ = command.number;
    const bool isOld = now() - command.time > patience;
    return isOld || isLost_ || !isAnswering_ ? Vector{} : command.force;
  }
  /// The force taken last was sent to the device.
  void noteSent() noexcept { sent_.store(taken_); }
  /// The device answered.
  void deliver(const Sample& sample) noexcept
  {
    isAnswering_ = true;
    samples_.put({sample, ++sequence_});
  }
  /// The device did not answer in time. No force until it does.
  void noteSilence() noexcept { isAnswering_ = false; }
  /// The device is gone until it is opened again.
  void lose() noexcept { isLost_ = true; }

  // --- The program's thread.

  /// Before the device's thread starts.
  void reset() noexcept
  {
    samples_.put({{}, sequence_});  // no button of an earlier exchange
    commands_.put({{}, 0, number_});
    sent_ = number_;
    isPushing_ = false;
    isLost_ = false;
    isAnswering_ = true;
  }
  std::int32_t read(PerilymphDeviceSampleV1& out) noexcept
  {
    const Delivered& newest = samples_.get();
    out.buttons = newest.sample.buttons;
    out.sequence = newest.sequence;
    std::copy(newest.sample.position.begin(), newest.sample.position.end(), out.position_D_m);
    std::copy(newest.sample.rotation.begin(), newest.sample.rotation.end(), out.rotation_D);
    // Without a fresh one yet it is valid, and old: a sample that is not valid is a lost device.
    out.is_valid = isLost_ ? 0 : 1;
    return 0;
  }
  /// Returns at once, but after the first zero, which it sees sent if that takes no longer than
  /// `zeroPatience`: the host calls write() with zero when the plug-in crashed, and its process ends
  /// right after.
  std::int32_t write(const PerilymphDeviceWrenchV1& wrench) noexcept
  {
    Vector force;
    std::copy_n(wrench.force_D_N, 3, force.begin());
    const double size = std::hypot(force[0], force[1], force[2]);
    if (!std::isfinite(size)) force = {};
    if (size > maxForce_)
      for (double& part : force) part *= maxForce_ / size;
    const bool isZero = force == Vector{};
    commands_.put({force, now(), ++number_});
    if (isZero && isPushing_) awaitZero();
    isPushing_ = !isZero;
    return isLost_ ? 1 : 0;
  }

  /// Longest time for which a force outlasts the program's thread [ns]: that of the program's own
  /// guards of devices.
  static constexpr std::int64_t patience = 50'000'000;
  /// One and a half periods of 1 ms; the program takes a sample for old after three [ns].
  static constexpr std::int64_t zeroPatience = 1'500'000;

private:
  struct Command {
    Vector force{};
    std::int64_t time = 0;  // [ns]
    std::uint64_t number = 0;
  };
  struct Delivered {
    Sample sample;
    std::uint64_t sequence = 0;
  };

  void awaitZero() const noexcept
  {
    const std::int64_t end = now() + zeroPatience;
    const timespec step{0, 50'000};
    while (sent_.load() < number_ && !isLost_ && now() < end) ::nanosleep(&step, nullptr);
  }

  double maxForce_;
  Newest<Command> commands_;
  Newest<Delivered> samples_;
  std::atomic<bool> isLost_{false}, isAnswering_{true};
  std::atomic<std::uint64_t> sent_{0};  // number of the newest command sent
  std::uint64_t number_ = 0;            // of the program's thread
  bool isPushing_ = false;              // of the program's thread
  std::uint64_t taken_ = 0;             // of the device's thread
  std::uint64_t sequence_ = 0;          // of the device's thread, never reset
};

}  // namespace perilymph::plugin
