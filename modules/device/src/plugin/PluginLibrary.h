// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A device plug-in's shared library, loaded by the process that hosts it.

#include <filesystem>
#include <memory>

#include "perilymph/device/PluginApi.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device::plugin {

struct CloseLibrary {
  void operator()(void* library) const noexcept;
};

/// The device of a plug-in and its functions; the library stays loaded as long as it exists.
class Library {
public:
  /// Loads the library, checks its interface and creates its device. The error continues "The
  /// plug-in is not taken:".
  static Result<Library> load(const std::filesystem::path& file);

  Library(Library&&) noexcept = default;
  Library& operator=(Library&&) noexcept = default;
  ~Library();

  const PerilymphDeviceV1& functions() const noexcept { return *functions_; }
  void* device() const noexcept { return device_.get(); }
  /// As stated by the plug-in, unchecked.
  const PerilymphDeviceTraitsV1& traits() const noexcept { return traits_; }

private:
  struct Keep {
    void operator()(void*) const noexcept {}
  };
  Library(std::unique_ptr<void, CloseLibrary> library, const PerilymphDeviceV1& functions,
          void* device) noexcept
      : library_(std::move(library)), functions_(&functions), device_(device)
  {
  }

  std::unique_ptr<void, CloseLibrary> library_;
  const PerilymphDeviceV1* functions_;
  std::unique_ptr<void, Keep> device_;  // destroyed by the plug-in, if it was not moved away
  PerilymphDeviceTraitsV1 traits_{};
};

}  // namespace perilymph::device::plugin
