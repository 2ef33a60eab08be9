// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A hand on a HID device that reports ten thousand times a second, in virtual time.

#include <atomic>
#include <cstdint>
#include <memory>

#include "hid/HidDevice.h"
#include "perilymph/test/FakeHid.h"

namespace perilymph::test {

/// Holds the grasp button. One at a time: its clock is that of the whole test.
class TenKilohertzHand {
public:
  static constexpr double period = 1e-4;              // [s]
  static constexpr std::int64_t period_ns = 100'000;  // [ns]

  TenKilohertzHand()
  {
    now = 1'000'000'000;
    hid.whenWaiting([this](Duration) { report(); });
  }

  /// The host's side of the device.
  std::unique_ptr<device::HidDevice> device()
  {
    device::DeviceTraits traits = fakeTraits();
    traits.nominalPeriod = period;
    return std::make_unique<device::HidDevice>(
        traits, std::make_unique<FakeCodec>(), hid.port(), +[]() noexcept { return now.load(); });
  }
  /// A period passes, and the device says where the hand is.
  void report()
  {
    now += period_ns;
    FakeReport report;
    report.counter = ++counter;
    report.place_10um[2] = static_cast<std::int16_t>(-inward_10um);
    report.buttons = device::graspButton;
    hid.send(report);
  }

  inline static std::atomic<std::int64_t> now{0};  ///< [ns]
  FakeHid hid;
  int inward_10um = 0;  ///< Where the hand is.

private:
  std::uint16_t counter = 0;
};

}  // namespace perilymph::test
