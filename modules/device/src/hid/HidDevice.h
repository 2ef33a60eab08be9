// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A HID device as input: read by the haptic thread, written by a thread of its own, supervised by a
// third.

#include <memory>

#include "codec/DeviceCodec.h"
#include "hid/HidPort.h"
#include "hid/ReportReader.h"
#include "perilymph/device/HapticDevice.h"

namespace perilymph::device {

/// Threads and their communication:
///
///     haptic      reads and decodes; stores forces in a mailbox of one slot         never waits
///     writer      takes the newest force, encodes and sends it                      may wait for
///                                                                                   seconds
///     supervisor  if the device is gone: closes the handles, opens new ones         may wait
///
/// It renders no force without a fresh report for three periods (3 ms to 30 ms), nor while the
/// device accepts none: a force pending for 5 ms (or three periods) means that the device is
/// blocked, and the sample is invalid until a zero force was accepted. If the haptic thread is
/// silent for as long, the writer sends zero by itself.
class HidDevice final : public HapticDevice {
public:
  /// @param traits  From the device's profile.
  /// @param clock   Time source of a test, else the monotonic clock.
  HidDevice(DeviceTraits traits, std::unique_ptr<DeviceCodec> codec, std::unique_ptr<HidPort> port,
            Clock clock = nullptr);
  ~HidDevice() override;  ///< Closes the device.

  /// Once open, with the measured period and delay.
  DeviceTraits traits() const override;
  /// Opens and prepares the device and listens to it for at most 0.1 s.
  Result<void> open() override;
  /// Sets the force to zero and switches the actuators off, as far as the device still responds. A
  /// write blocked in the system delays this by at most 5 s.
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
