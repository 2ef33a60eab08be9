#pragma once

// Every HID device of the system, and what the program makes of it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/device/DeviceProfile.h"
#include "perilymph/device/HidDevice.h"
#include "perilymph/device/HidNodes.h"

namespace perilymph::device {

/// One device, known or not.
struct FoundDevice {
  HidNode node;
  ReportDescriptor descriptor;           ///< Empty where it cannot be read.
  std::optional<DeviceProfile> profile;  ///< None: the program does not know it.
  std::string kind;      ///< In words: "mouse", "joystick", "vendor-defined (usage page 0xff00)".
  std::string obstacle;  ///< A sentence: why it cannot be a hand; empty if it can.

  /// What people call it: the profile's name, else the device's own, else its numbers.
  std::string name() const;
  bool isUsable() const noexcept { return obstacle.empty(); }
};

struct DeviceSurvey {
  std::vector<FoundDevice> devices;  ///< In the order of their nodes.
  std::vector<std::string> errors;   ///< Profiles that cannot be read: sentences.
};

/// Looks at every HID device without opening any.
DeviceSurvey surveyDevices(const SystemRoots& roots = {});

/// The same with profiles of the caller's.
DeviceSurvey surveyDevices(const std::vector<DeviceProfile>& profiles, const SystemRoots& roots);

/// The usable device of that name, node ("hidraw3" or its path) or numbers ("256f:c635"). A
/// sentence with those there are if none fits.
Result<FoundDevice> findDevice(const DeviceSurvey& survey, const std::string& nameOrNode);

/// The hand of a usable device; not yet open.
///
/// @param tape  Where to keep all its reports (ReportTape); nowhere without.
Result<std::unique_ptr<HidDevice>> makeHidDevice(const FoundDevice& found,
                                                 const SystemRoots& roots = {},
                                                 const std::filesystem::path& tape = {});

}  // namespace perilymph::device
