#pragma once

// A hand on a HID device: read by the haptic thread, written by a thread of its own, watched by a
// third.

#include <memory>

#include "perilymph/device/DeviceCodec.h"
#include "perilymph/device/HapticDevice.h"
#include "perilymph/device/HidPort.h"
#include "perilymph/device/ReportReader.h"

namespace perilymph::device {

/// Threads and what passes between them:
///
///     haptic      reads, decodes; leaves forces in a mailbox of one slot        never waits
///     writer      takes the newest force, encodes, sends                        may wait for
///     seconds supervisor  when the device is gone: closes the handles, opens new ones   may wait
///
/// It shows no force to a hand it has not heard of for three periods (3 ms to 30 ms), nor while the
/// device takes none: a force under way for 5 ms (or three periods) means the device is blocked,
/// and the hand is not valid until it has taken a zero force. If the haptic thread falls silent for
/// as long, the writer sends zero by itself.
class HidDevice final : public HapticDevice {
public:
  /// @param traits  What the device's profile says.
  /// @param clock   A test's own time, else the monotonic clock.
  HidDevice(DeviceTraits traits, std::unique_ptr<DeviceCodec> codec, std::unique_ptr<HidPort> port,
            Clock clock = nullptr);
  ~HidDevice() override;  ///< Closes.

  /// Once open with the period and the delay that were measured.
  DeviceTraits traits() const override;
  /// Opens the device, makes it ready and listens to it for at most 0.1 s.
  Result<Done> open() override;
  /// Zero force, actuators off, as far as the device still takes anything. A write that is stuck in
  /// the system holds this up, for 5 s at most.
  void close() noexcept override;
  DeviceSample read() noexcept override;
  void write(const Wrench& wrench_D) noexcept override;
  Awaited await(Duration timeout) noexcept override;
  std::optional<DeviceHealth> health() override;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::device
