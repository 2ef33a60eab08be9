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

/// What a profile states, whether or not a connected device fits it.
struct ProfileSummary {
  KnownDevice device;
  std::string kind;     ///< Kind of its reports: "vector".
  std::string matches;  ///< Its criteria: "1234:0006, or usage page 0x01, usage 0x04".
};

struct DeviceSurvey {
  std::vector<FoundDevice> devices;       ///< In the order of their nodes.
  std::optional<ProfileSummary> profile;  ///< The only one, if one was named.
  /// Messages: profiles that cannot be read, devices that the kernel refused.
  std::vector<std::string> errors;
};

/// Surveys all HID devices with the user's own and the shipped profiles, without opening any.
DeviceSurvey surveyDevices(const SystemRoots& roots = {});
/// The same with one profile only: the path of its file, or the file's name without ending.
Result<DeviceSurvey> surveyDevices(const SystemRoots& roots, const std::string& profile);

/// The usable device with that name, node ("hidraw3" or its path), place or identity ("256f:c635").
/// The error lists the available ones, and the places of several that are equal.
Result<FoundDevice> findDevice(const DeviceSurvey& survey, const std::string& nameOrNode);

/// Text by which a device is recognized when the program is started again: identity, place, serial
/// number.
std::string choiceText(const FoundDevice& found);

/// The usable device of a choiceText(): the one at its place, else the one with its serial number,
/// else the only one of its identity and interface. Null if there is none, or several.
const FoundDevice* chosenDevice(const DeviceSurvey& survey, const std::string& choice);

/// Makes a usable device; not yet open.
///
/// @param tape  File that all its reports are recorded to (ReportTape); none if empty.
Result<std::unique_ptr<HapticDevice>> makeHidDevice(const FoundDevice& found,
                                                    const SystemRoots& roots = {},
                                                    const std::filesystem::path& tape = {});

}  // namespace perilymph::device
