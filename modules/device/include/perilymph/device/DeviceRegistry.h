// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The HID devices of the system and their profiles.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/device/HidNodes.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

struct DeviceProfile;

/// What a device's profile states.
struct KnownDevice {
  std::string name;
  std::string confidence;  ///< high, medium or low
  DeviceTraits traits;
  std::string file;  ///< Path of the profile.
  /// Sentences: what its author notes, what was not verified, which other profile fits; or empty.
  std::string caution;
};

/// One HID device, with or without a profile.
struct FoundDevice {
  HidNode node;
  std::optional<KnownDevice> known;  ///< Empty for an unknown device.
  std::string kind;      ///< Description: "mouse", "joystick", "vendor-defined (usage page
                         ///< 0xff00)".
  std::string obstacle;  ///< A sentence: why it cannot be used; empty if it can.
  /// The profile that makeHidDevice() uses; null for an unknown device.
  std::shared_ptr<const DeviceProfile> profile;

  /// Display name: the profile's, else the device's own, else vendor and product numbers.
  std::string name() const;
  bool isUsable() const noexcept { return obstacle.empty(); }
};

struct DeviceSurvey {
  std::vector<FoundDevice> devices;  ///< In the order of their nodes.
  /// Messages: profiles that cannot be read, devices that the kernel refused.
  std::vector<std::string> errors;
};

/// Surveys all HID devices with the user's own and the shipped profiles, without opening any.
DeviceSurvey surveyDevices(const SystemRoots& roots = {});
/// The same with one profile only: the path of its file, or the file's name without ending.
Result<DeviceSurvey> surveyDevices(const SystemRoots& roots, const std::string& profile);

/// The usable device with that name, node ("hidraw3" or its path) or identity ("256f:c635"). The
/// error lists the available ones.
Result<FoundDevice> findDevice(const DeviceSurvey& survey, const std::string& nameOrNode);

/// Makes a usable device; not yet open.
///
/// @param tape  File that all its reports are recorded to (ReportTape); none if empty.
Result<std::unique_ptr<HapticDevice>> makeHidDevice(const FoundDevice& found,
                                                    const SystemRoots& roots = {},
                                                    const std::filesystem::path& tape = {});

}  // namespace perilymph::device
