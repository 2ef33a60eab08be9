// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The HID devices of the system, read from sysfs without opening them.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace perilymph::device {

/// USB or Bluetooth identity of a HID interface.
struct HidIdentity {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  int interfaceNumber = -1;  ///< -1 if the system does not report it.
};

/// Whether this user may open a node for reading and writing.
enum class NodeAccess : std::uint8_t {
  allowed,
  denied,  ///< The node exists, but not for this user: a udev rule is missing.
  absent,  ///< Known to sysfs, but without a node in /dev (a container).
};

/// One hidraw node.
struct HidNode {
  std::filesystem::path path;  ///< /dev/hidraw0
  std::uint32_t bus = 0;       ///< 3: USB, 5: Bluetooth, 6: virtual (uhid).
  HidIdentity identity;
  std::string name;    ///< Name reported by the device.
  std::string serial;  ///< Empty if it has none.
  /// Where it is plugged in, as the kernel states it: "usb-0000:00:14.0-2/input0". Equal devices have
  /// different ones. Empty if it is unknown.
  std::string place;
  std::vector<std::uint8_t> descriptor;  ///< Empty if it cannot be read.
  NodeAccess access = NodeAccess::absent;
};

/// Root folders of sysfs and /dev.
struct SystemRoots {
  std::filesystem::path sysfs = "/sys";
  std::filesystem::path dev = "/dev";
};

/// The system's own; if the environment variable PERILYMPH_SYSTEM_ROOT is set, the folders `sys`
/// and `dev` in that folder: a tree recorded elsewhere. A file in place of a node is a ReportTape
/// and is played.
SystemRoots systemRoots();

/// Every hidraw node, in numerical order. Nodes that vanish meanwhile are omitted.
std::vector<HidNode> findHidNodes(const SystemRoots& roots = {});

/// HID devices on the bus without a hidraw node: the kernel refused their report descriptor or has no
/// driver for them. Their `path` is that on the bus.
std::vector<HidNode> findRefusedDevices(const SystemRoots& roots = {});

/// The file for a rule of the user's own: another name than that of the shipped rules, which it would
/// hide, and before systemd's 73-seat-late.rules.
inline constexpr const char* localRulesFile = "/etc/udev/rules.d/71-perilymph-local.rules";

/// The udev rule that lets the user at the machine open devices of this vendor and product, on any
/// bus.
std::string udevRule(std::uint16_t vendor, std::uint16_t product);

/// "1234:0006", as printed by lsusb.
std::string identityText(const HidIdentity& identity);

/// Whether two nodes are the same device, before and after it was reconnected: vendor, product,
/// interface and descriptor are equal, and the serial number if both have one.
bool isSameDevice(const HidNode& one, const HidNode& other);

}  // namespace perilymph::device
