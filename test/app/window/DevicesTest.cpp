// SPDX-License-Identifier: BSD-3-Clause

// The devices in the window.

#include <gtest/gtest.h>

#include <QLabel>

#include "WindowRig.h"
#include "gui/pages/devices/DevicePage.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/RecordedTree.h"

namespace perilymph::test {
namespace {

/// A window on a machine with the devices of a recorded tree.
class DevicesOfTheWindow : public testing::Test {
protected:
  DevicesOfTheWindow()
  {
    qputenv("PERILYMPH_SYSTEM_ROOT", QByteArray::fromStdString(tree_.root().string()));
  }
  ~DevicesOfTheWindow() override { qunsetenv("PERILYMPH_SYSTEM_ROOT"); }

  void open() { rig_ = std::make_unique<WindowRig>(); }
  gui::DevicePage& page() { return *rig_->window().findChild<gui::DevicePage*>(); }
  bool pageSays(const char* caption)
  {
    for (const QLabel* label : page().findChildren<QLabel*>())
      if (label->text().contains(QLatin1String(caption))) return true;
    return false;
  }

  RecordedTree tree_;
  std::unique_ptr<WindowRig> rig_;
};

TEST_F(DevicesOfTheWindow, AreReportedAsNoneWithTheInputsThatNeedNone)
{
  open();
  rig_->pressKey(Qt::Key_H);
  ASSERT_TRUE(page().isVisible());
  EXPECT_TRUE(pageSays("No HID device"));
  EXPECT_TRUE(pageSays("mouse and keyboard"));
  rig_->pressKey(Qt::Key_H);
  EXPECT_FALSE(page().isVisible());
}

TEST_F(DevicesOfTheWindow, AreNamedWithWhatTheyAre)
{
  tree_.add({"0003:ABCD:0002.0001", "Some joystick", "hidraw0", "00"});
  tree_.add({"0003:1234:0006.0002", "WoodenHaptics", "hidraw1", "00"});
  tree_.addNode("hidraw0");
  tree_.addNode("hidraw1");
  open();
  rig_->pressKey(Qt::Key_H);
  // by usage and by number
  EXPECT_TRUE(pageSays("Joystick"));
  EXPECT_TRUE(pageSays("abcd:0002"));
  EXPECT_TRUE(pageSays("WoodenHaptics"));
  EXPECT_TRUE(pageSays("force up to"));
  EXPECT_TRUE(rig_->button("use-hidraw1").isEnabled());
  for (const QLabel* label : page().findChildren<QLabel*>())
    EXPECT_TRUE(label->wordWrap() || label->width() >= label->sizeHint().width())
        << label->text().toStdString();
  if (getenv("GRAB")) rig_->window().grab().save(getenv("GRAB"));
}

/// One second of a WoodenHaptics at rest: encoder counts in the layout of its profile.
std::string restingWoodenHaptics()
{
  std::string tape = "D: 0\nN: WoodenHaptics\nI: 3 1234 0006\n";
  for (int i = 0; i < 1000; ++i) {
    char line[96];
    std::snprintf(line, sizeof line,
                  "E: 000000.%03d000 14 00 00 00 00 70 17 00 00 00 00 00 00 00 00\n", i);
    tape += line;
  }
  return tape;
}

TEST_F(DevicesOfTheWindow, ThatCannotRenderTheCouplingAreSaidToBeSoftened)
{
  tree_.add({"0003:1234:0006.0002", "WoodenHaptics", "hidraw1", "00"});
  tree_.addTape("hidraw1", restingWoodenHaptics());
  open();
  rig_->pressKey(Qt::Key_H);
  rig_->click("use-hidraw1");
  const auto isSoftened = [this] {
    return rig_->label("statusLabel").contains(QLatin1String("coupling"));
  };
  ASSERT_TRUE(WindowRig::waitUntil([&] { return isSoftened(); }));
  // 0.75 b / (T/2 + half a period + delay) is at most 0.75 x 0.5 / 1 ms = 375 N/m of 441.
  EXPECT_TRUE(pageSays("of the 441 N/m asked for"));
  EXPECT_TRUE(pageSays("Input: WoodenHaptics"));
  EXPECT_TRUE(rig_->label("hintLabel").contains(QLatin1String("Coupling stiffness limited to")));
  EXPECT_GT(rig_->now().couplingStiffness, 0.0);
  EXPECT_LE(rig_->now().couplingStiffness, 375.0);
  for (const QLabel* label : page().findChildren<QLabel*>())
    EXPECT_GE(label->height(), label->wordWrap() ? label->heightForWidth(label->width()) : 0)
        << label->text().toStdString();
  const auto* status = rig_->window().findChild<QLabel*>(QStringLiteral("statusLabel"));
  EXPECT_GE(status->height(), status->heightForWidth(status->width()));
  if (getenv("GRAB_COUPLING")) rig_->window().grab().save(getenv("GRAB_COUPLING"));
}

TEST_F(DevicesOfTheWindow, OfAPlugInBecomesTheHandAndMovesTheArray)
{
  open();
  rig_->window().insertion().useDevice(examplePlugin());
  EXPECT_EQ(rig_->window().control().inputName(), "Example handle");
  EXPECT_TRUE(rig_->button("deviceChoice").text().contains("Example handle"));
  // Its virtual hand pushes inward with 0.2 N and never releases the button.
  rig_->click("startButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 1.0; }));
}

TEST_F(DevicesOfTheWindow, OfAFileThatIsNoPlugInLeaveTheScriptAndSayWhy)
{
  open();
  rig_->window().insertion().useDevice(tree_.root() / "none.so");
  EXPECT_EQ(rig_->window().control().input(), gui::InputSource::scripted);
  EXPECT_TRUE(rig_->label("bannerText").contains(QLatin1String("none.so")));
}

}  // namespace
}  // namespace perilymph::test
