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
#include "perilymph/foundation/Resources.h"
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
    return "No profile fits it: " + found.kind + ". For a device of a known kind add one to " +
           deviceProfileFolder().string() + " (plugins/README.md).";
  if (node.access == NodeAccess::absent)
    return "There is no " + node.path.string() +
           ": this system shows its devices without their nodes, as a container does.";
  if (node.access == NodeAccess::denied)
    return "You may not open " + node.path.string() + ". Put this line into " + localRulesFile +
           ", then plug the device in again: " +
           udevRule(node.identity.vendor, node.identity.product);
  if (const auto codec = makeCodec(*found.profile, descriptor); !codec)
    return codec.error().message;
  return {};
}

/// Warnings about a profile that was found for a device.
std::string cautionOf(const DeviceProfile& profile, const ProfileCatalog& catalog,
                      const HidIdentity& identity, const ReportDescriptor& descriptor)
{
  std::string text = profile.note;
  const auto add = [&text](const std::string& sentence) {
    text += (text.empty() ? "" : " ") + sentence;
  };
  if (profile.traits.rendersForce && profile.confidence != "high")
    add("Signs and magnitude of its force were not verified on this device: a wrong sign pulls the "
        "hand instead of resisting it. Hold the device loosely in its first test.");
  const int fit = fitOf(profile.matches, identity, descriptor);
  for (const DeviceProfile& other : catalog.profiles)
    if (other.file != profile.file && fitOf(other.matches, identity, descriptor) == fit)
      add(other.file + " fits as well; choose it with --profile.");
  return text;
}

/// The error of a broken profile that is, or may be, meant for this device; empty if there is none.
/// Another profile must not replace it silently.
std::string brokenFor(const FoundDevice& found, const ProfileCatalog& catalog,
                      const ReportDescriptor& descriptor)
{
  constexpr int ofThisProduct = 16;
  const HidIdentity& identity = found.node.identity;
  const int used = found.profile ? fitOf(found.profile->matches, identity, descriptor) : 0;
  for (const BrokenProfile& broken : catalog.broken) {
    const int meant = fitOf(broken.matches, identity, descriptor);
    const bool isUnknown = broken.matches.empty() && used > 0 && used < ofThisProduct;
    if ((meant == 0 || meant < used) && !isUnknown) continue;
    return broken.error + " It " + (isUnknown ? "may be" : "is") + " meant for this device" +
           (found.profile ? ", so " + found.profile->file + " is not used instead" : "") +
           ". Correct or remove it.";
  }
  return {};
}

/// Empty where it cannot be read.
ReportDescriptor descriptorOf(const HidNode& node)
{
  auto parsed = ReportDescriptor::parse(node.descriptor);
  return parsed ? *std::move(parsed) : ReportDescriptor{};
}

std::string kindName(CodecKind kind)
{
  switch (kind) {
    case CodecKind::encoders:
      return "encoders";
    case CodecKind::vector:
      return "vector";
    case CodecKind::pid:
      return "pid";
    case CodecKind::spaceMouse:
      return "spacemouse";
    case CodecKind::joystick:
      return "joystick";
  }
  return "unknown";
}

std::string usageText(const Usage& usage)
{
  char text[48];
  std::snprintf(text, sizeof text, "usage page 0x%02x, usage 0x%02x", usage.page, usage.id);
  return text;
}

/// The criteria of one [[match]].
std::string matchText(const DeviceMatch& match)
{
  std::string text;
  const auto add = [&text](const std::string& part) {
    text += (text.empty() ? "" : " with ") + part;
  };
  if (match.vendor && match.product)
    add(identityText({*match.vendor, *match.product, -1}));
  else if (match.vendor)
    add(identityText({*match.vendor, 0, -1}).substr(0, 5) + "*");
  if (match.interfaceNumber) add("interface " + std::to_string(*match.interfaceNumber));
  if (match.usage) add(usageText(*match.usage));
  if (match.contains) add("a collection of " + usageText(*match.contains));
  return text;
}

ProfileSummary summaryOf(const DeviceProfile& profile)
{
  ProfileSummary summary;
  summary.device = {profile.name, profile.confidence, traitsOf(profile), profile.file,
                    profile.note};
  summary.kind = kindName(profile.kind);
  for (const DeviceMatch& match : profile.matches)
    summary.matches += (summary.matches.empty() ? "" : ", or ") + matchText(match);
  return summary;
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
         name == lowered(node.place) || name == identityText(node.identity) ||
         name == lowered(found.name()) || name == lowered(node.name);
}

}  // namespace

std::string FoundDevice::name() const
{
  if (known) return known->name;
  return node.name.empty() ? identityText(node.identity) : node.name;
}

DeviceSurvey surveyDevices(const SystemRoots& roots) { return surveyDevices(allProfiles(), roots); }

Result<DeviceSurvey> surveyDevices(const SystemRoots& roots, const std::string& profile)
{
  auto named = namedProfile(profile);
  if (!named) return named.error();
  ProfileCatalog catalog;
  catalog.profiles.push_back(*std::move(named));
  DeviceSurvey survey = surveyDevices(catalog, roots);
  survey.profile = summaryOf(catalog.profiles.front());
  return survey;
}

DeviceSurvey surveyDevices(const ProfileCatalog& catalog, const SystemRoots& roots)
{
  DeviceSurvey survey;
  for (const BrokenProfile& broken : catalog.broken) survey.errors.push_back(broken.error);
  for (const HidNode& refused : findRefusedDevices(roots))
    survey.errors.push_back(
        identityText(refused.identity) + (refused.name.empty() ? "" : " (" + refused.name + ")") +
        " is plugged in, but the kernel made no node for it: it refused the device's report "
        "descriptor, or has no driver for it. 'journalctl -k' says which.");
  for (HidNode& node : findHidNodes(roots)) {
    FoundDevice found;
    found.node = std::move(node);
    const ReportDescriptor descriptor = descriptorOf(found.node);
    const HidIdentity& identity = found.node.identity;
    const DeviceProfile* const profile = matchingProfile(catalog.profiles, identity, descriptor);
    if (profile != nullptr) {
      found.profile = std::make_shared<const DeviceProfile>(*profile);
      found.known = {profile->name, profile->confidence, traitsOf(*profile, descriptor),
                     profile->file, cautionOf(*profile, catalog, identity, descriptor)};
    }
    found.kind = kindOf(descriptor);
    found.obstacle = brokenFor(found, catalog, descriptor);
    if (found.obstacle.empty()) found.obstacle = obstacleOf(found, descriptor);
    survey.devices.push_back(std::move(found));
  }
  return survey;
}

Result<FoundDevice> findDevice(const DeviceSurvey& survey, const std::string& nameOrNode)
{
  std::string usable, places;
  const FoundDevice* match = nullptr;
  int matches = 0;
  for (const FoundDevice& found : survey.devices) {
    if (found.isUsable()) usable += (usable.empty() ? "" : ", ") + found.name();
    if (!isCalled(found, nameOrNode)) continue;
    // A device of several interfaces: the one that can be used is meant.
    if (match == nullptr || (found.isUsable() && !match->isUsable())) match = &found;
    if (!found.isUsable()) continue;
    ++matches;
    const HidNode& node = found.node;
    places += (places.empty() ? "" : ", ") + (node.place.empty() ? node.path.string() : node.place);
  }
  if (matches > 1)
    return Error{"There are %1 devices '%2'. Give the place of one: %3.", matches, nameOrNode,
                 places};
  if (match != nullptr && match->isUsable()) return *match;
  if (match != nullptr) return Error{"%1 cannot be the input. %2", match->name(), match->obstacle};
  return Error{
      "There is no device '%1'. %2", nameOrNode,
      (usable.empty() ? "No usable haptic device is plugged in." : "There are: " + usable + ".")};
}

namespace {

/// Identity and interface, equal for equal devices.
std::string modelText(const HidNode& node)
{
  return identityText(node.identity) + "." + std::to_string(node.identity.interfaceNumber);
}

}  // namespace

std::string choiceText(const FoundDevice& found)
{
  return modelText(found.node) + " " + found.node.place + " " + found.node.serial;
}

const FoundDevice* chosenDevice(const DeviceSurvey& survey, const std::string& choice)
{
  const FoundDevice* sameSerial = nullptr;
  const FoundDevice* sameModel = nullptr;
  int ofSerial = 0, ofModel = 0;  // boards of one firmware have equal serial numbers, too
  for (const FoundDevice& found : survey.devices) {
    const HidNode& node = found.node;
    const std::string model = modelText(node) + " ";
    if (!found.isUsable() || !choice.starts_with(model)) continue;
    if (!node.place.empty() && choice.starts_with(model + node.place + " ")) return &found;
    if (!node.serial.empty() && choice.ends_with(" " + node.serial)) {
      sameSerial = &found;
      ++ofSerial;
    }
    sameModel = &found;
    ++ofModel;
  }
  if (ofSerial == 1) return sameSerial;
  return ofModel == 1 ? sameModel : nullptr;
}

Result<std::unique_ptr<HapticDevice>> makeHidDevice(const FoundDevice& found,
                                                    const SystemRoots& roots,
                                                    const std::filesystem::path& tape)
{
  if (!found.isUsable()) return Error{"%1 cannot be the input. %2", found.name(), found.obstacle};
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
