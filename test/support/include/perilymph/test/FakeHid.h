// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A simulated HID device, with the faults of real ones.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "codec/DeviceCodec.h"
#include "hid/HidPort.h"

namespace perilymph::test {

/// Content of a FakeHid's report: a counter, a position in steps of 10 um, buttons.
struct FakeReport {
  std::uint16_t counter = 0;
  std::array<std::int16_t, 3> place_10um{};
  std::uint8_t buttons = 0;

  device::RawReport raw() const;
};

/// The device side. Like Linux, it keeps 63 reports for each open handle and drops later ones. Any
/// thread.
class FakeHid {
public:
  FakeHid();

  /// The host side: for a HidDevice, or to be opened directly.
  std::unique_ptr<device::HidPort> port();
  std::unique_ptr<device::Transport> open();

  /// Sends an input report to every open handle.
  void send(const device::RawReport& report);
  void send(const FakeReport& report) { send(report.raw()); }

  void unplug();  ///< All handles become invalid; a pending write fails.
  void plugIn();
  void holdWrites(bool isHeld);       ///< NAK: a write blocks until released.
  void refuseWrites(bool isRefused);  ///< Writes fail; the device remains connected.
  /// The feature report that switches actuators on or off fails.
  void refuseActuators(bool isRefused);
  /// Limits the number of handles that can be opened, as if another program used the device.
  void maxOpen(int handles);
  /// Called without a lock when a feature report is requested; without it the request fails.
  void whenRequested(std::function<device::Transfer(device::RawReport&)> answer);
  /// Called without a lock by a read that would wait: time passes, and a report may arrive.
  void whenWaiting(std::function<void(Duration)> passTime);

  /// Output reports accepted so far.
  std::vector<device::RawReport> written() const;
  /// Forces accepted so far, as encoded by FakeCodec [N].
  std::vector<std::array<double, 3>> forces() const;
  bool areActuatorsOn() const;
  bool isWriteWaiting() const;  ///< A write is currently blocked.
  int opened() const;           ///< Handles opened so far.

private:
  friend class FakeTransport;
  friend class FakePort;
  struct State;
  std::shared_ptr<State> state_;
};

/// The codec of a FakeHid. A force is one report of three numbers in mN; a feature report switches
/// actuators on and off.
class FakeCodec final : public device::DeviceCodec {
public:
  std::optional<std::uint64_t> decode(const device::RawReport& report,
                                      device::DeviceSample& hand) noexcept override;
  void encode(const device::Wrench& wrench_D, device::ReportList& reports) noexcept override;
  Result<void> begin(device::Transport& transport) override;
  void end(device::Transport& transport) noexcept override;
};

/// Traits of a FakeHid that reports every millisecond.
device::DeviceTraits fakeTraits();

}  // namespace perilymph::test
