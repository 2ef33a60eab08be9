// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/DeviceRegistry.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <utility>

#include "codec/DeviceCodec.h"
#include "hid/DeviceSurvey.h"
#include "hid/HidDevice.h"
#include "tape/TapePorts.h"

namespace perilymph::device {

namespace {

/// Type of a main collection (HID Usage Tables 1.4, chapters 3 and 4).
std::string kindOf(const ReportDescriptor& descriptor)
{
  constexpr std::array<std::pair<Usage, const char*>, 9> label = {
      {{{0x01, 0x01}, "pointer"},
       {{0x01, 0x02}, "mouse"},
       {{0x01, 0x04}, "joystick"},
       {{0x01, 0x05}, "game pad"},
       {{0x01, 0x06}, "keyboard"},
       {{0x01, 0x07}, "keypad"},
       {{0x01, 0x08}, "multi-axis controller"},
       {{0x0c, 0x01}, "consumer control"},
       {{0x0f, 0x01}, "force-feedback device"}}};
  const auto usage = descriptor.application();
  if (!usage) return "a device without a usage in its report descriptor";
  for (const auto& [known, word] : label)
    if (known == *usage) return word;
  char text[64];
  const char* const sort = usage->page >= 0xff00 ? "vendor-defined" : "another device";
  std::snprintf(text, sizeof text, "%s (usage page 0x%02x, usage 0x%02x)", sort, usage->page,
                usage->id);
  return text;
}

std::string obstacleOf(const FoundDevice& found, const ReportDescriptor& descriptor)
{
  const HidNode& node = found.node;
  if (!found.profile)
    return "No profile below plugins/devices fits it: " + found.kind +
           ". For a device of a known kind add one (plugins/README.md).";
  if (node.access == NodeAccess::absent)
    return "There is no " + node.path.string() +
           ": this system shows its devices without their nodes, as a container does.";
  if (node.access == NodeAccess::denied)
    return "You may not open " + node.path.string() +
           ". Put this line into /etc/udev/rules.d/70-perilymph.rules, then plug the device in "
           "again: " +
           udevRule(node.identity.vendor, node.identity.product);
  if (const auto codec = makeCodec(*found.profile, descriptor); !codec)
    return codec.error().message;
  return {};
}

/// Empty where it cannot be read.
ReportDescriptor descriptorOf(const HidNode& node)
{
  auto parsed = ReportDescriptor::parse(node.descriptor);
  return parsed ? *std::move(parsed) : ReportDescriptor{};
}

std::string lowered(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

bool isCalled(const FoundDevice& found, const std::string& wanted)
{
  const HidNode& node = found.node;
  const std::string name = lowered(wanted);
  return name == node.path.string() || name == node.path.filename().string() ||
         name == identityText(node.identity) || name == lowered(found.name()) ||
         name == lowered(node.name);
}

}  // namespace

std::string FoundDevice::name() const
{
  if (known) return known->name;
  return node.name.empty() ? identityText(node.identity) : node.name;
}

DeviceSurvey surveyDevices(const SystemRoots& roots)
{
  ProfileCatalog catalog = shippedProfiles();
  DeviceSurvey survey = surveyDevices(catalog.profiles, roots);
  survey.errors = std::move(catalog.errors);
  return survey;
}

DeviceSurvey surveyDevices(const std::vector<DeviceProfile>& profiles, const SystemRoots& roots)
{
  DeviceSurvey survey;
  for (HidNode& node : findHidNodes(roots)) {
    FoundDevice found;
    found.node = std::move(node);
    const ReportDescriptor descriptor = descriptorOf(found.node);
    const DeviceProfile* const profile = matchingProfile(profiles, found.node.identity, descriptor);
    if (profile != nullptr) {
      found.profile = std::make_shared<const DeviceProfile>(*profile);
      found.known = {profile->name, profile->confidence, traitsOf(*profile, descriptor)};
    }
    found.kind = kindOf(descriptor);
    found.obstacle = obstacleOf(found, descriptor);
    survey.devices.push_back(std::move(found));
  }
  return survey;
}

Result<FoundDevice> findDevice(const DeviceSurvey& survey, const std::string& nameOrNode)
{
  std::string usable;
  for (const FoundDevice& found : survey.devices) {
    if (isCalled(found, nameOrNode)) {
      if (found.isUsable()) return found;
      return Error{found.name() + " cannot be the hand. " + found.obstacle};
    }
    if (found.isUsable()) usable += (usable.empty() ? "" : ", ") + found.name();
  }
  return Error{"There is no device '" + nameOrNode + "'. " +
               (usable.empty() ? "No device that could be a hand is plugged in."
                               : "There are: " + usable + ".")};
}

Result<std::unique_ptr<HapticDevice>> makeHidDevice(const FoundDevice& found,
                                                    const SystemRoots& roots,
                                                    const std::filesystem::path& tape)
{
  if (!found.isUsable()) return Error{found.name() + " cannot be the hand. " + found.obstacle};
  auto codec = makeCodec(*found.profile, descriptorOf(found.node));
  if (!codec) return codec.error();
  auto port = hidPort(found.node, roots);
  if (!tape.empty()) {
    ReportTape head;
    head.name = found.node.name;
    head.bus = found.node.bus;
    head.identity = found.node.identity;
    head.descriptor = found.node.descriptor;
    auto recording = recordingPort(std::move(port), tape, head);
    if (!recording) return recording.error();
    port = *std::move(recording);
  }
  return std::unique_ptr<HapticDevice>(
      std::make_unique<HidDevice>(found.known->traits, *std::move(codec), std::move(port)));
}

}  // namespace perilymph::device
