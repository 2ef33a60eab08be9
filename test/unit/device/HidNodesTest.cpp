// SPDX-License-Identifier: BSD-3-Clause

// Discovery in recorded trees: folders with the layout of /sys and /dev.

#include "perilymph/device/HidNodes.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "perilymph/test/RecordedTree.h"

namespace perilymph::device {
namespace {

namespace fs = std::filesystem;
using test::RecordedTree;

TEST(HidNodes, AreNoneOnASystemWithoutHid)
{
  EXPECT_TRUE(findHidNodes(RecordedTree().roots()).empty());
}

TEST(HidNodes, TellWhatTheKernelKnowsOfADevice)
{
  RecordedTree tree;
  tree.add({"0003:1234:0006.0001", "Polhem HID device", "hidraw0", "02"});
  tree.addNode("hidraw0");
  const auto nodes = findHidNodes(tree.roots());
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].path, tree.dev() / "hidraw0");
  EXPECT_EQ(nodes[0].bus, 3u);
  EXPECT_EQ(nodes[0].identity.vendor, 0x1234);
  EXPECT_EQ(nodes[0].identity.product, 6);
  EXPECT_EQ(nodes[0].identity.interfaceNumber, 2);
  EXPECT_EQ(nodes[0].name, "Polhem HID device");
  EXPECT_EQ(nodes[0].place, "usb-0000:00:14.0-1/input0");
  EXPECT_EQ(nodes[0].descriptor.size(), 7u);
  EXPECT_EQ(nodes[0].access, NodeAccess::allowed);
}

TEST(HidNodes, HaveNoInterfaceOnBluetooth)
{
  RecordedTree tree;
  tree.add({"0005:256F:C63A.0004", "SpaceMouse", "hidraw1", ""});
  const auto nodes = findHidNodes(tree.roots());
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].bus, 5u);
  EXPECT_EQ(nodes[0].identity.interfaceNumber, -1);
}

TEST(HidNodes, ComeInTheOrderOfTheirNumbers)
{
  RecordedTree tree;
  for (const char* node : {"hidraw10", "hidraw2", "hidraw0"})
    tree.add({"0003:1234:0006.0001", "Hand", node, "00"});
  const auto nodes = findHidNodes(tree.roots());
  ASSERT_EQ(nodes.size(), 3u);
  EXPECT_EQ(nodes[0].path.filename(), "hidraw0");
  EXPECT_EQ(nodes[1].path.filename(), "hidraw2");
  EXPECT_EQ(nodes[2].path.filename(), "hidraw10");
}

TEST(HidNodes, SayWhatMayNotBeOpened)
{
  RecordedTree tree;
  tree.add({"0003:1234:0006.0001", "Hand", "hidraw0", "00"});
  EXPECT_EQ(findHidNodes(tree.roots()).at(0).access, NodeAccess::absent);
  tree.addNode("hidraw0");
  if (geteuid() == 0) GTEST_SKIP() << "root may open everything";
  fs::permissions(tree.dev() / "hidraw0", fs::perms::none);
  EXPECT_EQ(findHidNodes(tree.roots()).at(0).access, NodeAccess::denied);
}

TEST(HidNodes, SkipInvalidEntries)
{
  RecordedTree tree;
  fs::create_directories(tree.sys() / "class/hidraw/hidraw3/device");  // no uevent
  fs::create_directories(tree.sys() / "class/hidraw/hidrawX");
  fs::create_directories(tree.sys() / "class/hidraw/hidraw4/device");
  std::ofstream(tree.sys() / "class/hidraw/hidraw4/device/uevent") << "HID_ID=zz:1:2\n";
  EXPECT_TRUE(findHidNodes(tree.roots()).empty());
}

TEST(HidNodes, RecognizeADeviceUnderAnotherNumber)
{
  RecordedTree tree;
  tree.add({"0003:1234:0006.0001", "Hand", "hidraw0", "00"});
  tree.add({"0003:1234:0006.0007", "Hand", "hidraw5", "00"});
  tree.add({"0003:1234:0006.0008", "Hand", "hidraw6", "01"});
  const auto nodes = findHidNodes(tree.roots());
  EXPECT_TRUE(isSameDevice(nodes.at(0), nodes.at(1)));
  EXPECT_FALSE(isSameDevice(nodes.at(0), nodes.at(2)));  // its other interface
}

// systemd's 73-seat-late.rules gives devices with the tag "uaccess" to the user at the machine, so
// the rule must come earlier and set the tag, not a mode.
TEST(UdevRule, TagsAndNeverOpensToEverybody)
{
  const std::string rule = udevRule(0x256f, 0xc63a);
  EXPECT_EQ(rule, R"(SUBSYSTEM=="hidraw", KERNELS=="*:256F:C63A.*", TAG+="uaccess")");
  EXPECT_EQ(rule.find("MODE"), std::string::npos);
}

}  // namespace
}  // namespace perilymph::device
