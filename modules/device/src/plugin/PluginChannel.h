// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Communication between the program and the process that hosts a device plug-in: descriptors,
// requests, and memory that both share.

#include <array>
#include <atomic>
#include <cstdint>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/device/PluginApi.h"
#include "perilymph/realtime/Doorbell.h"
#include "perilymph/realtime/SharedValue.h"

namespace perilymph::device::plugin {

/// The host's file descriptors at its start.
enum File : int {
  requests = 0,  ///< A pipe from the program. It closes when the program ends.
  channel = 3,   ///< Memory shared with the program: a Channel.
  replies = 4,   ///< A pipe to the program.
};

/// Version of this header: a host of another version is refused.
inline constexpr std::uint32_t version = 2;

/// Requests of the program, one letter each.
enum Request : char {
  open = 'o',     ///< Open the device, then exchange forces and samples. Replied.
  close = 'c',    ///< Force to zero, close the device. Replied.
  goodbye = 'b',  ///< End. Not replied.
};

/// Answer to a request, and the first message of a host, which tells how loading went.
struct Reply {
  std::uint32_t version = plugin::version;
  std::uint32_t isDone = 0;  ///< 0 if it failed; then the sentence states why.
  PerilymphDeviceTraitsV1 traits{};
  std::array<char, 512> sentence{};
};
static_assert(sizeof(Reply) <= 4096, "a pipe takes it whole (PIPE_BUF)");

/// The functions of a plug-in that a host calls after loading it.
enum class Function : std::uint32_t { none, load, open, close, read, write };

/// Status of a host that ended on its own.
enum End : int {
  inOrder = 0,
  hungInRead = 81,   ///< read() did not return: the host wrote zero, closed the device and ended.
  hungInWrite = 82,  ///< write() did not return: the host ended.
  abandoned = 83,    ///< The program is gone, and another function did not return.
};

/// A force for the plug-in.
struct Force {
  std::uint64_t number = 0;          ///< Counts the forces.
  std::array<double, 3> force_D{};   ///< [N]
  std::array<double, 3> torque_D{};  ///< [N.m]
  std::uint64_t isMeasured = 0;      ///< Answer at once: the program measures the delay.
};

/// The newest sample of the plug-in.
struct HostedSample {
  DeviceSample sample;           ///< Finite, whatever the plug-in returns.
  std::uint64_t written = 0;     ///< Number of the newest force that the plug-in accepted.
  std::uint64_t faulty = 0;      ///< Number of samples that were not finite.
  std::uint32_t isFaulty = 0;    ///< The last one was not.
  std::uint32_t isRefusing = 0;  ///< The plug-in did not accept the last force.
};

/// Shared memory, created by the program.
struct Channel {
  realtime::SharedValue<Force> forces;          ///< From the program.
  realtime::SharedValue<HostedSample> samples;  ///< From the host.
  realtime::Doorbell forHost{realtime::Sharing::processes};
  realtime::Doorbell forProgram{realtime::Sharing::processes};
  std::atomic<std::uint32_t> isClosing{0};         ///< Program: a request to close follows.
  std::atomic<Function> function{Function::none};  ///< Host: the function that runs now.
  std::atomic<std::uint64_t> calls{0};             ///< Host: number of calls that returned.
};
static_assert(std::atomic<Function>::is_always_lock_free);

}  // namespace perilymph::device::plugin
