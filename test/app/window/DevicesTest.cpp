// SPDX-License-Identifier: BSD-3-Clause

// The devices in the window.

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <filesystem>
#include <fstream>

#include "WindowRig.h"
#include "gui/pages/devices/DevicePage.h"
#include "gui/run/UserSettings.h"
#include "perilymph/device/PluginDevice.h"
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
  ~DevicesOfTheWindow() override
  {
    rig_.reset();
    qunsetenv("PERILYMPH_SYSTEM_ROOT");
    gui::UserSettings().remove(QStringLiteral("input/device"));
    std::filesystem::remove_all(plugins());
  }

  /// The user's folder of plug-ins, in the data home of this test program.
  bool isInput(const std::string& name)
  {
    return WindowRig::waitUntil([&] { return rig_->window().control().inputName() == name; });
  }
  static std::filesystem::path plugins() { return device::pluginFolders().front(); }
  static void install(const std::filesystem::path& file, const std::string& name)
  {
    std::filesystem::create_directories(plugins());
    std::filesystem::copy_file(file, plugins() / name);
  }
  QPushButton* pageButton(const char* name)
  {
    return page().findChild<QPushButton*>(QLatin1String(name));
  }

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
  ASSERT_TRUE(isInput("Example handle"));
  EXPECT_TRUE(rig_->button("deviceChoice").text().contains("Example handle"));
  // Its virtual hand pushes inward with 0.2 N and never releases the button.
  rig_->click("startButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 1.0; }));
}

TEST_F(DevicesOfTheWindow, OfAnInstalledPlugInAreListedChosenRememberedAndRemoved)
{
  install(examplePlugin(), "lab.so");
  open();
  rig_->pressKey(Qt::Key_H);
  // loaded in the background, in a process of its own
  ASSERT_TRUE(WindowRig::waitUntil([&] { return pageButton("use-lab") != nullptr; }));
  EXPECT_TRUE(pageSays("force up to 3.0 N"));
  EXPECT_TRUE(pageSays((plugins() / "lab.so").c_str()));
  EXPECT_FALSE(pageSays("chosen last"));
  rig_->click("use-lab");
  ASSERT_TRUE(isInput("Example handle"));
  rig_->pressKey(Qt::Key_H);

  // The next choice of a device is this one, at once.
  rig_->click("scriptedChoice");
  EXPECT_EQ(rig_->window().control().input(), gui::InputSource::scripted);
  rig_->click("deviceChoice");
  ASSERT_TRUE(isInput("Example handle"));
  EXPECT_FALSE(page().isVisible());
  rig_->click("deviceChoice");  // in use already: the list
  ASSERT_TRUE(page().isVisible());
  ASSERT_TRUE(WindowRig::waitUntil([&] { return pageButton("use-lab") != nullptr; }));
  EXPECT_TRUE(pageSays("Example handle (chosen last)"));

  std::filesystem::remove(plugins() / "lab.so");
  rig_->click("devicesRefreshButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return pageSays("No plug-in is installed."); }));
  EXPECT_EQ(pageButton("use-lab"), nullptr);
  rig_->pressKey(Qt::Key_H);
  rig_->click("scriptedChoice");
  rig_->click("deviceChoice");  // the remembered one is gone: the list
  EXPECT_TRUE(page().isVisible());
}

TEST_F(DevicesOfTheWindow, OfAPlugInThatIsRefusedAreListedWithTheReason)
{
  std::filesystem::create_directories(plugins());
  std::ofstream(plugins() / "text.so") << "no library";
  open();
  rig_->pressKey(Qt::Key_H);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return pageSays("it is not a shared library"); }));
  EXPECT_EQ(pageButton("use-text"), nullptr);
}

TEST_F(DevicesOfTheWindow, OfOneModelAreChosenAgainByTheirPlace)
{
  tree_.add({"0003:1234:0006.0001", "WoodenHaptics", "hidraw1", "00"});
  tree_.add({.kernelName = "0003:1234:0006.0002",
             .name = "WoodenHaptics",
             .node = "hidraw2",
             .interface = "00",
             .place = "usb-0000:00:14.0-4/input0"});
  tree_.addTape("hidraw1", restingWoodenHaptics());
  tree_.addTape("hidraw2", restingWoodenHaptics());
  open();
  rig_->pressKey(Qt::Key_H);
  EXPECT_TRUE(pageSays("usb-0000:00:14.0-1/input0"));
  EXPECT_TRUE(pageSays("usb-0000:00:14.0-4/input0"));
  rig_->click("use-hidraw2");
  const QString kept = gui::UserSettings().value(QStringLiteral("input/device")).toString();
  EXPECT_TRUE(kept.contains(QLatin1String("usb-0000:00:14.0-4/input0"))) << kept.toStdString();
  rig_->click("devicesRefreshButton");
  int marked = 0;
  for (const QLabel* label : page().findChildren<QLabel*>())
    marked += label->text().contains(QLatin1String("chosen last")) ? 1 : 0;
  EXPECT_EQ(marked, 1);
}

TEST_F(DevicesOfTheWindow, OfAFileThatIsNoPlugInLeaveTheScriptAndSayWhy)
{
  open();
  rig_->window().insertion().useDevice(tree_.root() / "none.so");
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return rig_->label("bannerText").contains(QLatin1String("none.so")); }));
  EXPECT_EQ(rig_->window().control().input(), gui::InputSource::scripted);

  // The script does not insert in place of the device without being chosen.
  rig_->click("startButton");
  EXPECT_FALSE(rig_->window().control().isRunning());
  EXPECT_TRUE(rig_->label("bannerText").contains(QLatin1String("is not open")));
  rig_->window().insertion().reset();  // tries the device again
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return rig_->label("bannerText").contains(QLatin1String("none.so")); }));
  rig_->click("scriptedChoice");
  rig_->click("startButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 0.0; }));
}

/// A plug-in that hangs: PERILYMPH_TEST_FAULT names the function.
class HangingPlugIn : public DevicesOfTheWindow {
protected:
  void TearDown() override
  {
    ::unsetenv("PERILYMPH_TEST_FAULT");
    DevicesOfTheWindow::TearDown();
  }
  QWidget* stage() { return rig_->window().findChild<QWidget*>(QStringLiteral("loadingStage")); }
  /// Chooses it, and how long the window's thread was busy with that [s].
  double use(const char* fault)
  {
    ::setenv("PERILYMPH_TEST_FAULT", fault, 1);
    const auto began = std::chrono::steady_clock::now();
    rig_->window().insertion().useDevice(testPlugin("socket_device"));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }
};

TEST_F(HangingPlugIn, LeavesTheWindowFreeAndIsCanceled)
{
  open();
  EXPECT_LT(use("hang in create"), 3.0) << "10 s until it is given up";
  ASSERT_TRUE(stage()->isVisible());
  EXPECT_TRUE(rig_->label("loadingText").contains(QLatin1String("socket_device is being opened")));
  EXPECT_TRUE(WindowRig::waitUntil([&] {
    return rig_->label("loadingText")
        .contains(QLatin1String("socket_device has not answered for "));
  }));
  rig_->pressKey(Qt::Key_Space);
  EXPECT_FALSE(rig_->window().control().isRunning()) << "the script is not what was chosen";
  rig_->click("cancelLoadingButton");
  EXPECT_FALSE(stage()->isVisible());
  EXPECT_EQ(rig_->window().control().input(), gui::InputSource::scripted);
  rig_->click("startButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 0.0; }));
}

TEST_F(HangingPlugIn, IsGivenUpWithASentence)
{
  open();
  EXPECT_LT(use("hang in create"), 3.0);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return !stage()->isVisible(); }));
  EXPECT_TRUE(rig_->label("bannerText").contains(QLatin1String("did not answer within 10 s")));
  EXPECT_EQ(rig_->window().control().input(), gui::InputSource::scripted);
}

TEST_F(HangingPlugIn, IsLeftByEsc)
{
  open();
  use("hang in create");
  ASSERT_TRUE(stage()->isVisible());
  rig_->pressKey(Qt::Key_Escape);
  EXPECT_FALSE(stage()->isVisible());
}

}  // namespace
}  // namespace perilymph::test
