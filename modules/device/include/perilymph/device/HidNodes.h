#pragma once

// Which HID devices the system has, read from sysfs: nothing is opened to find out.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/device/DeviceProfile.h"

namespace perilymph::device {

/// Whether this user may open a node for reading and writing.
enum class NodeAccess : std::uint8_t {
  allowed,
  denied,  ///< The node is there, but not for this user: a udev rule is missing.
  absent,  ///< sysfs knows the device, /dev has no node for it (a container).
};

/// One hidraw node.
struct HidNode {
  std::filesystem::path path;  ///< /dev/hidraw0
  std::uint32_t bus = 0;       ///< 3 is USB, 5 Bluetooth, 6 a program's (uhid).
  HidIdentity identity;
  std::string name;                      ///< As the device calls itself.
  std::string serial;                    ///< Empty where it has none.
  std::vector<std::uint8_t> descriptor;  ///< Empty where it cannot be read.
  NodeAccess access = NodeAccess::absent;
};

/// Where the system keeps its devices.
struct SystemRoots {
  std::filesystem::path sysfs = "/sys";
  std::filesystem::path dev = "/dev";
};

/// The system's own; with PERILYMPH_SYSTEM_ROOT in the environment the folders `sys` and `dev` in
/// that one: a tree recorded elsewhere. A file there in place of a node is a ReportTape, and is
/// played.
SystemRoots systemRoots();

/// Every hidraw node, in the order of their numbers. Nodes that vanish while they are looked at are
/// left out.
std::vector<HidNode> findHidNodes(const SystemRoots& roots = {});

/// The udev rule that lets whoever sits at the machine open devices of this vendor and product, on
/// whatever bus.
std::string udevRule(std::uint16_t vendor, std::uint16_t product);

/// "1234:0006", as lsusb writes it.
std::string identityText(const HidIdentity& identity);

/// Whether two nodes are the same device, before and after it was plugged in again: vendor,
/// product, interface and descriptor agree, and the serial number where both have one.
bool isSameDevice(const HidNode& one, const HidNode& other);

}  // namespace perilymph::device
