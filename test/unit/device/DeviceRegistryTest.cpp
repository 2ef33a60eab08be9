// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/DeviceRegistry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hid/DeviceSurvey.h"
#include "hid/HidPort.h"
#include "perilymph/test/RecordedTree.h"

namespace perilymph::device {
namespace {

using test::RecordedTree;
using testing::HasSubstr;

// HID 1.11, appendix E.10: the report descriptor of the example mouse.
const std::string mouse(
    "\x05\x01\x09\x02\xa1\x01\x09\x01\xa1\x00\x05\x09\x19\x01\x29\x03\x15\x00\x25\x01\x95\x03\x75"
    "\x01"
    "\x81\x02\x95\x01\x75\x05\x81\x01\x05\x01\x09\x30\x09\x31\x15\x81\x25\x7f\x75\x08\x95\x02\x81"
    "\x06"
    "\xc0\xc0",
    50);

// A stick of two axes of 8 bits and eight buttons.
const std::string stick(
    "\x05\x01\x09\x04\xa1\x01\x15\x81\x25\x7f\x75\x08\x95\x02\x09\x30\x09\x31\x81\x02\x05\x09\x19"
    "\x01"
    "\x29\x08\x15\x00\x25\x01\x75\x01\x95\x08\x81\x02\xc0",
    37);

DeviceSurvey surveyOf(const RecordedTree& tree)
{
  return surveyDevices(shippedProfiles(), tree.roots());
}

TEST(DeviceSurvey, KnowsAJoystickByWhatItIs)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0001.0001", "A stick", "hidraw0", "00", stick});
  tree.addNode("hidraw0");
  const DeviceSurvey survey = surveyOf(tree);
  ASSERT_EQ(survey.devices.size(), 1u);
  EXPECT_EQ(survey.devices[0].kind, "joystick");
  EXPECT_TRUE(survey.devices[0].known.has_value());
  EXPECT_TRUE(survey.devices[0].isUsable()) << survey.devices[0].obstacle;
}

TEST(DeviceSurvey, SaysWhatADeviceWithoutAProfileIs)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0002.0001", "A mouse", "hidraw0", "00", mouse});
  tree.addNode("hidraw0");
  const DeviceSurvey survey = surveyOf(tree);
  ASSERT_EQ(survey.devices.size(), 1u);
  EXPECT_FALSE(survey.devices[0].isUsable());
  EXPECT_THAT(survey.devices[0].obstacle, HasSubstr("No profile"));
  EXPECT_THAT(survey.devices[0].obstacle, HasSubstr("mouse"));
}

TEST(DeviceSurvey, SurvivesAnInvalidDescriptor)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0002.0001", "Broken", "hidraw0", "00", "\xff\xfe\xfd"});
  tree.addNode("hidraw0");
  const DeviceSurvey survey = surveyOf(tree);
  ASSERT_EQ(survey.devices.size(), 1u);
  EXPECT_FALSE(survey.devices[0].isUsable());
}

TEST(DeviceSurvey, ReportsAMissingNode)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0001.0001", "A stick", "hidraw0", "00", stick});
  EXPECT_THAT(surveyOf(tree).devices.at(0).obstacle, HasSubstr("container"));
}

TEST(DeviceChoice, FindsADeviceByNameNodeOrNumbers)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0001.0001", "A Stick", "hidraw3", "00", stick});
  tree.addNode("hidraw3");
  const DeviceSurvey survey = surveyOf(tree);
  const std::string profile = survey.devices.at(0).name();
  for (const std::string& name :
       {std::string("hidraw3"), std::string("a stick"), std::string("abcd:0001"), profile}) {
    const auto found = findDevice(survey, name);
    ASSERT_TRUE(found) << name << ": " << found.error().message;
    EXPECT_EQ(found->node.path.filename(), "hidraw3");
  }
}

TEST(DeviceChoice, NamesThoseThereAre)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0001.0001", "A stick", "hidraw0", "00", stick});
  tree.addNode("hidraw0");
  const DeviceSurvey survey = surveyOf(tree);
  const auto found = findDevice(survey, "banana");
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr("'banana'"));
  EXPECT_THAT(found.error().message, HasSubstr(survey.devices.at(0).name()));
}

/// Two equal sticks at two ports.
class TwoSticks : public testing::Test {
protected:
  TwoSticks()
  {
    for (const auto& device : {left_, right_}) {
      tree_.add(device);
      tree_.addNode(device.node);
    }
  }
  DeviceSurvey survey() const { return surveyOf(tree_); }
  std::string choiceOf(const std::string& node) const
  {
    return choiceText(*findDevice(survey(), node));
  }
  std::string chosen(const std::string& choice) const
  {
    const DeviceSurvey now = survey();
    const FoundDevice* const found = chosenDevice(now, choice);
    return found == nullptr ? "none" : found->node.path.filename().string();
  }

  RecordedTree tree_;
  const RecordedTree::Device left_{"0003:ABCD:0001.0001",       "A stick", "hidraw0", "00", stick,
                                   "usb-0000:00:14.0-1/input0", ""};
  const RecordedTree::Device right_{"0003:ABCD:0001.0002",       "A stick", "hidraw1", "00", stick,
                                    "usb-0000:00:14.0-4/input0", ""};
};

TEST_F(TwoSticks, AreToldApartByTheirPlace)
{
  const auto either = findDevice(survey(), "A stick");
  ASSERT_FALSE(either);
  EXPECT_THAT(either.error().message, HasSubstr("There are 2 devices 'A stick'"));
  EXPECT_THAT(either.error().message,
              HasSubstr("usb-0000:00:14.0-1/input0, usb-0000:00:14.0-4/input0"));
  const auto right = findDevice(survey(), "usb-0000:00:14.0-4/input0");
  ASSERT_TRUE(right) << right.error().message;
  EXPECT_EQ(right->node.path.filename(), "hidraw1");
}

TEST_F(TwoSticks, AreChosenAgainByTheirPlaceWhateverTheirNumber)
{
  const std::string right = choiceOf("hidraw1");
  EXPECT_EQ(chosen(right), "hidraw1");
  // After a restart the kernel may have counted them in the other order.
  tree_.remove(left_);
  tree_.remove(right_);
  RecordedTree::Device moved = right_;
  moved.node = "hidraw7";
  moved.kernelName = "0003:ABCD:0001.0009";
  RecordedTree::Device other = left_;
  other.node = "hidraw8";
  other.kernelName = "0003:ABCD:0001.0010";
  for (const auto& device : {moved, other}) {
    tree_.add(device);
    tree_.addNode(device.node);
  }
  EXPECT_EQ(chosen(right), "hidraw7");
}

TEST_F(TwoSticks, AreNotTakenForEachOther)
{
  RecordedTree::Device third = left_;
  third.node = "hidraw2";
  third.kernelName = "0003:ABCD:0001.0003";
  third.place = "usb-0000:00:14.0-6/input0";
  tree_.add(third);
  tree_.addNode(third.node);
  const std::string choice = choiceOf("hidraw2");
  tree_.remove(third);
  EXPECT_EQ(chosen(choice), "none");
  // The only one that is left is the one whose cable was moved.
  tree_.remove(left_);
  EXPECT_EQ(chosen(choice), "hidraw1");
}

constexpr const char* stickTape = "D: 0\nN: A stick\nI: 3 abcd 0001\nE: 000000.000000 3 80 80 00\n";

TEST_F(TwoSticks, AreNotOpenedInPlaceOfEachOther)
{
  tree_.addTape("hidraw0", stickTape);
  tree_.addTape("hidraw1", stickTape);
  const auto port = hidPort(survey().devices.at(0).node, tree_.roots());
  ASSERT_TRUE(port->open());
  tree_.remove(left_);  // its cable is pulled; the other one lies on the table
  const auto opened = port->open();
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, HasSubstr("is not plugged in"));
  RecordedTree::Device again = left_;
  again.node = "hidraw9";
  again.kernelName = "0003:ABCD:0001.0009";
  tree_.add(again);
  tree_.addTape("hidraw9", stickTape);
  EXPECT_TRUE(port->open());
}

TEST(DeviceChoice, OpensTheOnlyDeviceOfItsModelAtAnotherPort)
{
  RecordedTree tree;
  RecordedTree::Device device{"0003:ABCD:0001.0001", "A stick", "hidraw0", "00", stick};
  tree.add(device);
  tree.addTape("hidraw0", stickTape);
  const auto port = hidPort(surveyOf(tree).devices.at(0).node, tree.roots());
  ASSERT_TRUE(port->open());
  tree.remove(device);
  EXPECT_FALSE(port->open());
  device.node = "hidraw3";
  device.kernelName = "0003:ABCD:0001.0004";
  device.place = "usb-0000:00:14.0-7/input0";
  tree.add(device);
  tree.addTape("hidraw3", stickTape);
  EXPECT_TRUE(port->open());
}

TEST(DeviceChoice, FollowsASerialNumberToAnotherPort)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0001.0001", "A stick", "hidraw0", "00", stick, "usb-1", "SN1"});
  tree.add({"0003:ABCD:0001.0002", "A stick", "hidraw1", "00", stick, "usb-2", "SN2"});
  tree.addNode("hidraw0");
  tree.addNode("hidraw1");
  const DeviceSurvey survey = surveyOf(tree);
  const FoundDevice* const found = chosenDevice(survey, "abcd:0001.0 usb-9 SN2");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->node.path.filename(), "hidraw1");
  EXPECT_EQ(chosenDevice(survey, "abcd:0001.0 usb-9 SN3"), nullptr);
  EXPECT_EQ(chosenDevice(survey, ""), nullptr);
}

TEST(DeviceChoice, SaysThatNothingIsPluggedIn)
{
  const auto found = findDevice({}, "banana");
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr("No usable haptic device"));
}

TEST(DeviceChoice, CannotOpenWhatIsNoHidNode)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0001.0001", "A stick", "hidraw0", "00", stick});
  tree.addNode("hidraw0");  // a plain file
  const auto found = findDevice(surveyOf(tree), "hidraw0");
  ASSERT_TRUE(found);
  auto hand = makeHidDevice(*found, tree.roots());
  ASSERT_TRUE(hand) << hand.error().message;
  const auto opened = (*hand)->open();
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, HasSubstr("cannot be opened"));
}

}  // namespace
}  // namespace perilymph::device
