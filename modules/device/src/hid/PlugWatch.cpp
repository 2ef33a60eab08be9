// SPDX-License-Identifier: BSD-3-Clause
#include "hid/PlugWatch.h"

#include <libudev.h>
#include <poll.h>

#include <algorithm>

namespace perilymph::device {

struct PlugWatch::Content {
  struct Close {
    void operator()(udev* one) const noexcept { udev_unref(one); }
    void operator()(udev_monitor* one) const noexcept { udev_monitor_unref(one); }
  };
  std::unique_ptr<udev, Close> context;
  std::unique_ptr<udev_monitor, Close> monitor;
};

PlugWatch::PlugWatch() : content_(std::make_unique<Content>())
{
  content_->context.reset(udev_new());
  if (!content_->context) return;
  // "udev" events come after the rules have run, when the node may be opened.
  content_->monitor.reset(udev_monitor_new_from_netlink(content_->context.get(), "udev"));
  udev_monitor* const monitor = content_->monitor.get();
  if (monitor == nullptr) return;
  const bool listens =
      udev_monitor_filter_add_match_subsystem_devtype(monitor, "hidraw", nullptr) >= 0 &&
      udev_monitor_enable_receiving(monitor) >= 0;
  if (!listens) content_->monitor.reset();
}

PlugWatch::~PlugWatch() = default;

bool PlugWatch::await(Duration timeout) noexcept
{
  const int milliseconds = static_cast<int>(std::clamp(timeout.si(), 0.0, 60.0) * 1e3);
  udev_monitor* const monitor = content_->monitor.get();
  pollfd socket{};
  socket.fd = monitor != nullptr ? udev_monitor_get_fd(monitor) : -1;  // -1: poll only waits
  socket.events = POLLIN;
  if (poll(&socket, 1, milliseconds) <= 0 || monitor == nullptr) return false;
  udev_device* const device = udev_monitor_receive_device(monitor);
  if (device != nullptr) udev_device_unref(device);
  return device != nullptr;
}

}  // namespace perilymph::device
