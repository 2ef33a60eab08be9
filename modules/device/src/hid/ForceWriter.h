// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The writing side of a HID device: its thread.

#include <atomic>
#include <cstdint>

#include "codec/DeviceCodec.h"
#include "hid/ReportReader.h"
#include "perilymph/device/DeviceHealth.h"
#include "perilymph/realtime/Doorbell.h"
#include "perilymph/realtime/Handoff.h"
#include "perilymph/realtime/TimeHistogram.h"
#include "perilymph/realtime/TripleBuffer.h"

namespace perilymph::device {

/// Data shared by the threads of one device, with the writer of each member.
struct DeviceChannels {
  realtime::Handoff<Transport> reading;         ///< Supervisor lends, haptic thread uses.
  realtime::Handoff<Transport> writing;         ///< Supervisor lends, writer uses.
  realtime::TripleBuffer<Wrench> wrenches;      ///< Haptic thread to writer.
  realtime::TripleBuffer<RawReport> polled;     ///< Writer to haptic thread.
  realtime::Doorbell writerBell;                ///< Haptic thread and supervisor ring.
  realtime::Doorbell supervisorBell;            ///< Rung by the thread that finds the device gone.
  std::atomic<bool> isGone{false};              ///< Set by the thread that finds it, cleared by
                                                ///< supervisor.
  std::atomic<bool> isBlocked{false};           ///< Set by haptic thread, cleared by writer.
  std::atomic<bool> isStopping{false};          ///< UI thread.
  std::atomic<std::int64_t> busySince{0};       ///< Writer: since when a force is pending [ns]; 0:
                                                ///< none.
  std::atomic<std::uint64_t> blockedWrites{0};  ///< Haptic thread counts.
};

/// Sends forces until stopped, then zero and the codec's end reports.
class ForceWriter {
public:
  /// All references must outlive the writer. @param traits  Of the open device.
  ForceWriter(DeviceChannels& channels, DeviceCodec& codec, const DeviceTraits& traits,
              Clock clock);

  /// Main function of the writer's thread.
  void run() noexcept;

  /// Sends one force and counts its duration. Also used by the thread that opens the device.
  Transfer send(Transport& transport, const Wrench& wrench_D) noexcept;
  const WritingFigures& figures() noexcept;

  /// UI thread: recent figures.
  const WritingFigures& latestFigures() noexcept;

private:
  void serve(Transport& transport) noexcept;
  void poll(Transport& transport) noexcept;
  void lose() noexcept;

  DeviceChannels& channels_;
  DeviceCodec& codec_;
  const DeviceTraits& traits_;
  Clock clock_;
  std::int64_t patience_;  // maximum silence of the haptic thread [ns]
  std::int64_t period_;    // [ns]
  std::int64_t lastNew_ = 0;
  std::int64_t published_ = 0;
  bool isSilent_ = true;
  ReportList reports_;
  realtime::TimeHistogram times_;
  WritingFigures figures_;
  realtime::TripleBuffer<WritingFigures> shown_;
};

}  // namespace perilymph::device
