// SPDX-License-Identifier: BSD-3-Clause

// Simulates a force-feedback joystick of the PID class for the kernel: pid_stick SCENE
// SCENE: pid (a working joystick) or stuck (one that never answers a feature report).
// Ends when it was switched off after use, or on timeout.

#include <poll.h>
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "Descriptors.h"
#include "PidDevice.h"
#include "UhidDevice.h"
#include "perilymph/realtime/Pacer.h"

namespace {

using namespace perilymph;
using namespace perilymph::hidstack;
using device::RawReport;
using device::Transfer;
using device::test::PidDevice;

constexpr std::int64_t period = 2'000'000;         // [ns], as the shipped profile says
constexpr std::int64_t patience = 12'000'000'000;  // [ns], longer than the kernel's 5 s
constexpr std::int64_t afterwards = 100'000'000;   // [ns]
constexpr std::uint16_t vendor = 0x1209, product = 0x0002;

RawReport raw(std::span<const std::uint8_t> bytes)
{
  RawReport report;
  report.size = std::min(bytes.size(), device::longestReport);
  std::copy_n(bytes.begin(), report.size, report.bytes.begin());
  return report;
}

/// The joystick's firmware and connection.
class Stick {
public:
  explicit Stick(bool answers) : answers_(answers) { firmware_.actuatorsOn = false; }

  Result<void> plug()
  {
    return cable_.plug("Perilymph PID stick", vendor, product, device::test::pidDescriptor());
  }
  int file() const { return cable_.file(); }
  const PidDevice& firmware() const { return firmware_; }
  double maxShown() const { return maxShown_; }
  /// Its actuators were on, and are off again.
  bool wasUsed() const { return wasOn_ && !firmware_.actuatorsOn; }

  void listen()
  {
    std::span<const std::uint8_t> bytes;
    for (UhidEvent event = UhidEvent::other; event != UhidEvent::nothing;) {
      event = cable_.take(bytes);
      if (event == UhidEvent::output) firmware_.write(raw(bytes));
      if (event == UhidEvent::featureSet && answers_) set(bytes);
      if (event == UhidEvent::featureRequested && answers_) ask(bytes[0]);
      wasOn_ = wasOn_ || firmware_.actuatorsOn;
      maxShown_ = std::max(maxShown_, std::abs(firmware_.shown()[0]));
    }
  }
  /// X, Y and buttons: centered, the first button pressed.
  void report() { cable_.send(std::array<std::uint8_t, 6>{1, 0, 0, 0, 0, 1}); }

private:
  void set(std::span<const std::uint8_t> bytes)
  {
    if (firmware_.setFeature(raw(bytes)) == Transfer::done)
      cable_.accept();
    else
      cable_.refuse();
  }
  void ask(std::uint8_t number)
  {
    RawReport report;
    report.bytes[0] = number;
    report.size = 5;
    if (firmware_.getFeature(report) == Transfer::done)
      cable_.answer(report.view());
    else
      cable_.refuse();
  }

  bool answers_;
  bool wasOn_ = false;
  double maxShown_ = 0.0;  // along x, fraction of the maximum
  PidDevice firmware_;
  UhidDevice cable_;
};

void print(const std::string& scene, const Stick& stick)
{
  const auto& story = stick.firmware().story;
  const auto count = [&](const char* word) { return std::count(story.begin(), story.end(), word); };
  const auto measure = [&](const char* name, auto value) {
    std::cout << "measure " << scene << '.' << name << ' ' << value << '\n';
  };
  measure("created", count("create"));
  measure("started", count("start"));
  measure("freed", count("free"));
  measure("forces", count("force"));
  measure("max_fraction", stick.maxShown());
  measure("actuators_on", stick.firmware().actuatorsOn ? 1 : 0);
  const auto enabled = std::find(story.begin(), story.end(), "enable");
  measure("starts_after_enable", std::count(enabled, story.end(), "start"));
}

}  // namespace

int main(int count, char** text)
{
  if (count != 2) {
    std::cerr << "pid_stick needs the name of a scene.\n";
    return 2;
  }
  const std::string scene = text[1];
  sched_param wanted{};
  wanted.sched_priority = 90;  // higher than all programs, like hardware
  ::sched_setscheduler(0, SCHED_FIFO, &wanted);

  Stick stick(scene != "stuck");
  if (const auto plugged = stick.plug(); !plugged) {
    std::cerr << plugged.error().message << '\n';
    return 1;
  }
  const std::int64_t end = realtime::monotonicNanoseconds() + patience;
  std::int64_t due = realtime::monotonicNanoseconds(), over = end;
  while (due < over) {
    due += period;
    for (std::int64_t now = realtime::monotonicNanoseconds(); now < due;
         now = realtime::monotonicNanoseconds()) {
      const timespec rest{0, due - now};
      pollfd wait{stick.file(), POLLIN, 0};
      if (::ppoll(&wait, 1, &rest, nullptr) > 0) stick.listen();
    }
    stick.report();
    if (stick.wasUsed() && over == end) over = due + afterwards;
  }
  print(scene, stick);
  return 0;
}
