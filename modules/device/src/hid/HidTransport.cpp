// SPDX-License-Identifier: BSD-3-Clause
#include "hid/HidTransport.h"

#include <fcntl.h>
#include <hidapi/hidapi.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <mutex>
#include <utility>

#include "perilymph/realtime/Pacer.h"

namespace perilymph::device {

namespace {

/// hidapi keeps the text of its last error of opening in a global of the process.
std::mutex& openingMutex()
{
  static std::mutex mutex;
  return mutex;
}

/// Whether a node can be opened and is a HID device. hidapi 0.13 must not open any other: it then
/// frees uninitialized memory.
bool isHidraw(const std::filesystem::path& node)
{
  const int file = ::open(node.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return false;
  int size = 0;
  const bool answers = ::ioctl(file, HIDIOCGRDESCSIZE, &size) >= 0;
  ::close(file);
  return answers;
}

int inWholeMilliseconds(Duration timeout) noexcept
{
  const double milliseconds = std::ceil(std::clamp(timeout.si(), 0.0, 10.0) * 1e3 - 1e-6);
  return static_cast<int>(std::max(milliseconds, 0.0));
}

// hidapi waits in whole milliseconds, too coarse for a device of 10 kHz.
constexpr double shortestWait = 0.9e-3;  // [s]

class HidTransport final : public Transport {
public:
  HidTransport(hid_device* handle, ReportNumbers numbers) noexcept
      : handle_(handle), numbers_(numbers)
  {
  }
  ~HidTransport() override
  {
    const std::lock_guard lock(openingMutex());
    hid_close(handle_);
  }
  HidTransport(const HidTransport&) = delete;
  HidTransport& operator=(const HidTransport&) = delete;

  Transfer read(RawReport& report, Duration timeout) noexcept override
  {
    if (isGone_) return Transfer::gone;
    int count = timeout.si() > 0.0 && timeout.si() < shortestWait
                    ? takeSoon(report, timeout)
                    : take(report, inWholeMilliseconds(timeout));
    // A signal interrupts the wait like a disconnection; only the latter fails twice.
    if (count < 0) count = take(report, 0);
    if (count < 0) {
      isGone_ = true;
      return Transfer::gone;
    }
    return count == 0 ? Transfer::nothing : Transfer::done;
  }

  Transfer write(const RawReport& report) noexcept override
  {
    if (isGone_) return Transfer::gone;
    return outcome(hid_write(handle_, report.bytes.data(), report.size));
  }

  Transfer setFeature(const RawReport& report) noexcept override
  {
    if (isGone_) return Transfer::gone;
    return outcome(hid_send_feature_report(handle_, report.bytes.data(), report.size));
  }

  Transfer getFeature(RawReport& report) noexcept override
  {
    if (isGone_) return Transfer::gone;
    const std::size_t capacity = std::min(report.size, longestReport);
    const int count = hid_get_feature_report(handle_, report.bytes.data(), capacity);
    if (count > 0) report.size = static_cast<std::size_t>(count);
    return outcome(count);
  }

private:
  int take(RawReport& report, int milliseconds) noexcept
  {
    // hidapi omits the number if the device uses none.
    const std::size_t front = numbers_ == ReportNumbers::none ? 1 : 0;
    const int count =
        hid_read_timeout(handle_, report.bytes.data() + front, longestReport - front, milliseconds);
    if (count <= 0) return count;
    if (front == 1) report.bytes[0] = 0;
    report.size = static_cast<std::size_t>(count) + front;
    return count;
  }

  /// Waits for less than a millisecond by polling.
  int takeSoon(RawReport& report, Duration timeout) noexcept
  {
    constexpr timespec betweenReads{0, 20'000};
    const std::int64_t end =
        realtime::monotonicNanoseconds() + static_cast<std::int64_t>(timeout.si() * 1e9);
    int count = take(report, 0);
    while (count == 0 && realtime::monotonicNanoseconds() < end) {
      ::clock_nanosleep(CLOCK_MONOTONIC, 0, &betweenReads, nullptr);
      count = take(report, 0);
    }
    return count;
  }

  Transfer outcome(int count) noexcept
  {
    if (count >= 0) return Transfer::done;
    // Refused or disconnected? A node whose device is gone cannot be read either.
    RawReport ignored;
    if (take(ignored, 0) >= 0) return Transfer::failed;
    isGone_ = true;
    return Transfer::gone;
  }

  hid_device* handle_;
  ReportNumbers numbers_;
  bool isGone_ = false;
};

}  // namespace

Result<std::unique_ptr<Transport>> openHidTransport(const std::filesystem::path& node,
                                                    ReportNumbers numbers)
{
  const std::lock_guard lock(openingMutex());
  const bool canOpen = isHidraw(node) && hid_init() == 0;
  hid_device* handle = canOpen ? hid_open_path(node.c_str()) : nullptr;
  if (handle == nullptr)
    return Error{
        "The HID device %1 cannot be opened. See 'perilymph-cli devices' for what it is and who "
        "may open it, then plug it in again.",
        node};
  return std::unique_ptr<Transport>(std::make_unique<HidTransport>(handle, numbers));
}

}  // namespace perilymph::device
