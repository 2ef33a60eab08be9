// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The C interface of a device plug-in, from a C++ class.

#include <cstdio>
#include <exception>
#include <string>

#include "DeviceLink.h"

namespace perilymph::plugin {

/// The table of functions for a class with
///
///     static void state(PerilymphDeviceTraitsV1&)   fills in the traits
///     std::string open()                            an empty text, or a sentence for the user
///     void close()                                  after a force of zero was sent
///     DeviceLink& link()
///
/// No exception leaves a function.
template <class Device>
const PerilymphDeviceV1* pluginEntry() noexcept
{
  static const PerilymphDeviceV1 functions = {
      sizeof(PerilymphDeviceV1),
      1,
      []() -> void* {
        try {
          return new Device;
        } catch (const std::exception&) {
          return nullptr;
        }
      },
      [](void* device) { delete static_cast<Device*>(device); },
      [](void*, PerilymphDeviceTraitsV1* traits) -> std::int32_t {
        try {
          Device::state(*traits);
          return 0;
        } catch (const std::exception&) {
          return 1;
        }
      },
      [](void* device, char* sentence, std::uint32_t capacity) -> std::int32_t {
        std::string error;
        try {
          error = static_cast<Device*>(device)->open();
        } catch (const std::exception& exception) {
          error = exception.what();
        }
        if (!error.empty()) std::snprintf(sentence, capacity, "%s", error.c_str());
        return error.empty() ? 0 : 1;
      },
      [](void* device) { static_cast<Device*>(device)->close(); },
      [](void* device, PerilymphDeviceSampleV1* sample) {
        return static_cast<Device*>(device)->link().read(*sample);
      },
      [](void* device, const PerilymphDeviceWrenchV1* wrench) {
        return static_cast<Device*>(device)->link().write(*wrench);
      },
  };
  return &functions;
}

}  // namespace perilymph::plugin

/// Exports the plug-in whose device is the class.
#define PERILYMPH_DEVICE_PLUGIN(Device)                                                            \
  extern "C" __attribute__((visibility("default"))) const PerilymphDeviceV1* perilymph_device_v1() \
  {                                                                                                \
    return perilymph::plugin::pluginEntry<Device>();                                               \
  }                                                                                                \
  static_assert(true)
