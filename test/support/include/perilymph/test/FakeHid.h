#pragma once

// A HID device in memory, with the faults of real ones.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "perilymph/device/DeviceCodec.h"
#include "perilymph/device/HidPort.h"

namespace perilymph::test {

/// What a FakeHid reports: a counter, a place in steps of 10 um, buttons.
struct FakeReport {
  std::uint16_t counter = 0;
  std::array<std::int16_t, 3> place_10um{};
  std::uint8_t buttons = 0;

  device::RawReport raw() const;
};

/// The device's side. As Linux does, it keeps 63 reports for each open handle and drops what comes
/// after them. Any thread.
class FakeHid {
public:
  FakeHid();

  /// The host's side: give it to a HidDevice, or open it by hand.
  std::unique_ptr<device::HidPort> port();
  std::unique_ptr<device::Transport> open();

  /// Sends an input report to every open handle.
  void send(const device::RawReport& report);
  void send(const FakeReport& report) { send(report.raw()); }

  void unplug();  ///< Every handle is gone; a write on its way comes back so.
  void plugIn();
  void holdWrites(bool isHeld);       ///< NAK: a write does not return until it is let go.
  void refuseWrites(bool isRefused);  ///< A write fails; the device is still there.
  /// It stays off: the feature that turns actuators on or off fails.
  void refuseActuators(bool isRefused);
  /// No more handles than that can be opened, as where another program holds the device.
  void maxOpen(int handles);
  /// Called, with no lock, by whoever asks for a feature report; without it that fails.
  void whenAsked(std::function<device::Transfer(device::RawReport&)> answer);
  /// Called, with no lock, by a read that would wait: time passes, perhaps a report comes.
  void whenWaiting(std::function<void(Duration)> passTime);

  /// Output reports taken so far.
  std::vector<device::RawReport> written() const;
  /// Forces taken so far, as FakeCodec encodes them [N].
  std::vector<std::array<double, 3>> forces() const;
  bool areActuatorsOn() const;
  bool isWriteWaiting() const;  ///< A write is held at the moment.
  int opened() const;           ///< Handles opened so far.

private:
  friend class FakeTransport;
  friend class FakePort;
  struct State;
  std::shared_ptr<State> state_;
};

/// The codec of a FakeHid. A force is one report of three numbers in mN; actuators are turned on
/// and off by a feature report.
class FakeCodec final : public device::DeviceCodec {
public:
  std::optional<std::uint64_t> decode(const device::RawReport& report,
                                      device::DeviceSample& hand) noexcept override;
  void encode(const device::Wrench& wrench_D, device::ReportList& reports) noexcept override;
  Result<Done> begin(device::Transport& transport) override;
  void end(device::Transport& transport) noexcept override;
};

/// Traits of a FakeHid that reports every millisecond.
device::DeviceTraits fakeTraits();

}  // namespace perilymph::test
