#pragma once

// Tells when a hidraw node comes or goes, by udev's monitor.

#include <memory>

#include "perilymph/foundation/Units.h"

namespace perilymph::device {

class PlugWatch {
public:
  /// Without a udev (a container) it only waits.
  PlugWatch();
  ~PlugWatch();
  PlugWatch(const PlugWatch&) = delete;
  PlugWatch& operator=(const PlugWatch&) = delete;

  /// Waits until a node came or went, at most so long. False if nothing did.
  bool await(Duration timeout) noexcept;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::device
