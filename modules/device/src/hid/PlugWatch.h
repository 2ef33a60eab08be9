// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Waits for hidraw nodes to appear or disappear, by udev's monitor.

#include <memory>

#include "perilymph/foundation/Units.h"

namespace perilymph::device {

class PlugWatch {
public:
  /// Without udev (a container) it only waits.
  PlugWatch();
  ~PlugWatch();
  PlugWatch(const PlugWatch&) = delete;
  PlugWatch& operator=(const PlugWatch&) = delete;

  /// Waits until a node appeared or disappeared, at most `timeout`. False on timeout.
  bool await(Duration timeout) noexcept;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::device
