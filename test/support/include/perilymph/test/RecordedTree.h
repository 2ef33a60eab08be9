// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Folders with the structure of /sys and /dev of Linux, with HID devices.

#include <filesystem>
#include <fstream>
#include <string>

#include "perilymph/device/HidNodes.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

/// A tree with HID devices.
class RecordedTree {
public:
  struct Device {
    std::string kernelName;  ///< "0003:1234:0006.0001", as named by the kernel
    std::string name;
    std::string node;       ///< "hidraw0"
    std::string interface;  ///< USB interface; empty on other buses.
    std::string descriptor = std::string("\x05\x01\x09\x04\xa1\x01\xc0", 7);
    std::string place = "usb-0000:00:14.0-1/input0";
    std::string serial = {};
  };

  void add(const Device& device)
  {
    const std::filesystem::path parent =
        sys() / "devices/pci0000:00/usb1/1-1" / ("1-1:1." + device.node);
    const std::filesystem::path hid = parent / device.kernelName;
    std::filesystem::create_directories(hid / "hidraw" / device.node);
    if (!device.interface.empty()) write(parent / "bInterfaceNumber", device.interface + "\n");
    const std::string id = device.kernelName.substr(0, 4) + ":0000" +
                           device.kernelName.substr(5, 4) + ":0000" +
                           device.kernelName.substr(10, 4);
    write(hid / "uevent", "DRIVER=hid-generic\nHID_ID=" + id + "\nHID_NAME=" + device.name +
                              "\nHID_PHYS=" + device.place + "\nHID_UNIQ=" + device.serial + "\n");
    write(hid / "report_descriptor", device.descriptor);
    std::filesystem::create_directory_symlink(hid, hid / "hidraw" / device.node / "device");
    addToBus(hid);
    std::filesystem::create_directories(sys() / "class/hidraw");
    std::filesystem::create_directory_symlink(hid / "hidraw" / device.node,
                                              sys() / "class/hidraw" / device.node);
  }
  /// Takes a device away, as if its cable were pulled.
  void remove(const Device& device)
  {
    std::filesystem::remove(sys() / "class/hidraw" / device.node);
    std::filesystem::remove(dev() / device.node);
  }
  /// A device on the HID bus for which the kernel made no node.
  void addRefused(const std::string& kernelName, const std::string& name)
  {
    const std::string id = kernelName.substr(0, 4) + ":0000" + kernelName.substr(5, 4) + ":0000" +
                           kernelName.substr(10, 4);
    const std::filesystem::path hid = sys() / "devices/pci0000:00/usb1/1-2" / kernelName;
    write(hid / "uevent", "HID_ID=" + id + "\nHID_NAME=" + name + "\n");
    addToBus(hid);
  }
  void addNode(const std::string& node) { write(dev() / node, ""); }
  /// A node whose device plays a tape.
  void addTape(const std::string& node, const std::string& tape) { write(dev() / node, tape); }

  device::SystemRoots roots() const { return {sys(), dev()}; }
  const std::filesystem::path root() const { return folder_.path(); }
  std::filesystem::path sys() const { return folder_ / "sys"; }
  std::filesystem::path dev() const { return folder_ / "dev"; }

private:
  void addToBus(const std::filesystem::path& hid) const
  {
    std::filesystem::create_directories(sys() / "bus/hid/devices");
    const std::filesystem::path entry = sys() / "bus/hid/devices" / hid.filename();
    if (!std::filesystem::exists(entry)) std::filesystem::create_directory_symlink(hid, entry);
  }
  static void write(const std::filesystem::path& file, const std::string& text)
  {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }

  TemporaryFolder folder_;
};

}  // namespace perilymph::test
