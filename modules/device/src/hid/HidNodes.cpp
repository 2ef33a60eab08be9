// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/HidNodes.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>

#include "codec/ReportDescriptor.h"

namespace perilymph::device {

namespace {

namespace fs = std::filesystem;

/// Content of a sysfs file, at most one page, the kernel's limit.
std::string contentOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string content(ReportDescriptor::longest, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return content;
}

/// Value of KEY=value in a uevent file; empty if absent.
std::string valueOf(const std::string& uevent, std::string_view key)
{
  std::size_t from = 0;
  while (from < uevent.size()) {
    const std::size_t end = std::min(uevent.find('\n', from), uevent.size());
    const std::string_view line(uevent.data() + from, end - from);
    if (line.size() > key.size() && line.starts_with(key) && line[key.size()] == '=')
      return std::string(line.substr(key.size() + 1));
    from = end + 1;
  }
  return {};
}

std::optional<std::uint32_t> hexadecimal(std::string_view text)
{
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc{} || text.empty()) return std::nullopt;
  return value;
}

/// HID_ID=0003:00001234:00000006
bool readIdentity(const std::string& text, HidNode& node)
{
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string::npos ? first : text.find(':', first + 1);
  if (second == std::string::npos) return false;
  const auto bus = hexadecimal(std::string_view(text).substr(0, first));
  const auto vendor = hexadecimal(std::string_view(text).substr(first + 1, second - first - 1));
  const auto product = hexadecimal(std::string_view(text).substr(second + 1));
  if (!bus || !vendor || !product || *vendor > 0xffff || *product > 0xffff) return false;
  node.bus = *bus;
  node.identity.vendor = static_cast<std::uint16_t>(*vendor);
  node.identity.product = static_cast<std::uint16_t>(*product);
  return true;
}

/// Number of the USB interface, from the parent folder of the HID device.
int interfaceNumber(const fs::path& hidDevice)
{
  std::error_code error;
  const fs::path real = fs::canonical(hidDevice, error);
  if (error) return -1;
  std::string text = contentOf(real.parent_path() / "bInterfaceNumber");
  while (!text.empty() && text.back() <= ' ') text.pop_back();
  const auto number = hexadecimal(text);
  return number && *number <= 255 ? static_cast<int>(*number) : -1;
}

NodeAccess accessTo(const fs::path& node)
{
  std::error_code ignored;
  if (!fs::exists(node, ignored)) return NodeAccess::absent;
  const bool mayOpen = faccessat(AT_FDCWD, node.c_str(), R_OK | W_OK, AT_EACCESS) == 0;
  return mayOpen ? NodeAccess::allowed : NodeAccess::denied;
}

std::optional<HidNode> readNode(const fs::path& folder, const SystemRoots& roots)
{
  const fs::path hidDevice = folder / "device";
  const std::string uevent = contentOf(hidDevice / "uevent");
  HidNode node;
  if (!readIdentity(valueOf(uevent, "HID_ID"), node)) return std::nullopt;
  node.path = roots.dev / folder.filename();
  node.name = valueOf(uevent, "HID_NAME");
  node.serial = valueOf(uevent, "HID_UNIQ");
  node.place = valueOf(uevent, "HID_PHYS");
  node.identity.interfaceNumber = interfaceNumber(hidDevice);
  const std::string descriptor = contentOf(hidDevice / "report_descriptor");
  node.descriptor.assign(descriptor.begin(), descriptor.end());
  node.access = accessTo(node.path);
  return node;
}

/// Number of a hidraw node from its folder: 12 for hidraw12; empty for other names.
std::optional<int> nodeNumber(const fs::path& folder)
{
  constexpr std::string_view prefix = "hidraw";
  const std::string name = folder.filename().string();
  if (!name.starts_with(prefix)) return std::nullopt;
  int number = 0;
  const char* const last = name.data() + name.size();
  const auto [end, error] = std::from_chars(name.data() + prefix.size(), last, number);
  if (error != std::errc{} || end != last) return std::nullopt;
  return number;
}

}  // namespace

SystemRoots systemRoots()
{
  const char* const recorded = std::getenv("PERILYMPH_SYSTEM_ROOT");
  if (recorded == nullptr || *recorded == '\0') return {};
  const fs::path root(recorded);
  return {root / "sys", root / "dev"};
}

std::vector<HidNode> findHidNodes(const SystemRoots& roots)
{
  std::vector<std::pair<int, fs::path>> folders;
  std::error_code error;
  fs::directory_iterator entries(roots.sysfs / "class" / "hidraw", error);
  while (!error && entries != fs::directory_iterator{}) {
    if (const auto number = nodeNumber(entries->path()))
      folders.emplace_back(*number, entries->path());
    entries.increment(error);
  }
  std::sort(folders.begin(), folders.end());

  std::vector<HidNode> nodes;
  for (const auto& [number, folder] : folders)
    if (auto node = readNode(folder, roots)) nodes.push_back(std::move(*node));
  return nodes;
}

std::vector<HidNode> findRefusedDevices(const SystemRoots& roots)
{
  std::set<fs::path> withNode;
  std::error_code error;
  for (const HidNode& node : findHidNodes(roots))
    withNode.insert(
        fs::canonical(roots.sysfs / "class" / "hidraw" / node.path.filename() / "device", error));

  std::vector<HidNode> refused;
  fs::directory_iterator entries(roots.sysfs / "bus" / "hid" / "devices", error);
  while (!error && entries != fs::directory_iterator{}) {
    std::error_code ignored;
    const fs::path place = fs::canonical(entries->path(), ignored);
    const std::string uevent = contentOf(place / "uevent");
    HidNode node;
    if (withNode.count(place) == 0 && readIdentity(valueOf(uevent, "HID_ID"), node)) {
      node.path = entries->path();
      node.name = valueOf(uevent, "HID_NAME");
      refused.push_back(std::move(node));
    }
    entries.increment(error);
  }
  std::sort(refused.begin(), refused.end(),
            [](const HidNode& a, const HidNode& b) { return a.path < b.path; });
  return refused;
}

std::string udevRule(std::uint16_t vendor, std::uint16_t product)
{
  // The kernel names a HID device bus:vendor:product.number, in uppercase hexadecimal digits, on
  // every bus.
  char text[128];
  std::snprintf(text, sizeof text,
                R"(SUBSYSTEM=="hidraw", KERNELS=="*:%04X:%04X.*", TAG+="uaccess")", vendor,
                product);
  return text;
}

std::string identityText(const HidIdentity& identity)
{
  char text[16];
  std::snprintf(text, sizeof text, "%04x:%04x", identity.vendor, identity.product);
  return text;
}

bool isSameDevice(const HidNode& one, const HidNode& other)
{
  const bool isSameSerial =
      one.serial.empty() || other.serial.empty() || one.serial == other.serial;
  return one.identity.vendor == other.identity.vendor &&
         one.identity.product == other.identity.product &&
         one.identity.interfaceNumber == other.identity.interfaceNumber &&
         one.descriptor == other.descriptor && isSameSerial;
}

}  // namespace perilymph::device
