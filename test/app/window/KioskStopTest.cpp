// SPDX-License-Identifier: BSD-3-Clause

// The booth takes the force of a visitor's device away whenever it stops or leaves the insertion.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QLocale>
#include <QTest>
#include <memory>

#include "CutTexts.h"
#include "KeptPicture.h"
#include "PushedDevice.h"
#include "WindowRig.h"
#include "gui/kiosk/KioskWindow.h"
#include "gui/program/Languages.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using gui::KioskStage;

/// A way to stop or to leave, and the stage after it.
struct Leave {
  const char* name;
  KioskStage stage;
  void (*go)(gui::KioskWindow&);
  bool goesOn = false;  // with a following insertion
};

void press(gui::KioskWindow& window, const char* button)
{
  QTest::mouseClick(window.findChild<QAbstractButton*>(QLatin1String(button)), Qt::LeftButton);
}

const Leave leaves[] = {
    {"Escape", KioskStage::attract,
     [](gui::KioskWindow& window) { QTest::keyClick(&window, Qt::Key_Escape); }},
    {"StopButton", KioskStage::turn, [](gui::KioskWindow& window) { press(window, "stopButton"); }},
    {"StartOver", KioskStage::turn,
     [](gui::KioskWindow& window) { press(window, "startOverButton"); }, true},
    {"EndOfTheBooth", KioskStage::turn,
     [](gui::KioskWindow& window) {
       QTest::keyClick(&window, Qt::Key_Q, Qt::ControlModifier | Qt::AltModifier);
     }},
    {"ScreenLocked", KioskStage::turn, [](gui::KioskWindow& window) { window.stopDevice(); }},
    {"FocusLost", KioskStage::turn,
     [](gui::KioskWindow& window) {
       QEvent away(QEvent::WindowDeactivate);
       QApplication::sendEvent(&window, &away);
     }},
};

class BoothDevice : public testing::Test {
protected:
  /// A visitor pushes the device until it renders its largest force.
  void push()
  {
    auto scenario =
        session::loadScenario("contour-published", session::Overrides{{"force_scale", "20"},
                                                                      {"friction_static", "0.3"},
                                                                      {"friction_dynamic", "0.3"},
                                                                      {"nodes", "40"}});
    ASSERT_TRUE(scenario) << scenario.error().message;
    window_ = std::make_unique<gui::KioskWindow>(*scenario, folder_.path() / "board.txt",
                                                 gui::KioskClock(), WindowRig::sharedCochleae());
    window_->show();
    ASSERT_TRUE(window_->open());
    window_->useDevice([this] {
      return Result<std::unique_ptr<device::HapticDevice>>(std::make_unique<PushedDevice>(log_));
    });
    ASSERT_EQ(window_->control().inputName(), "Pushed device");
    log_->isPushed = true;
    ASSERT_TRUE(WindowRig::waitUntil([&] { return log_->isAtDepth.load(); }));
    // It holds the array there, and does not push that of a following insertion.
    log_->isPushed = false;
    ASSERT_TRUE(
        WindowRig::waitUntil([&] { return log_->newest() > 0.99 * PushedDevice::maxForce; }));
  }

  const std::shared_ptr<ForceLog> log_ = std::make_shared<ForceLog>();
  TemporaryFolder folder_;
  std::unique_ptr<gui::KioskWindow> window_;
};

class EveryWayToLeave : public BoothDevice, public testing::WithParamInterface<Leave> {};

TEST_P(EveryWayToLeave, TakesTheForceAwayWithinFiveTicks)
{
  push();
  if (HasFatalFailure()) return;
  const std::size_t before = log_->size();
  GetParam().go(*window_);
  // A following insertion renders the force of an array at its start: the log is searched for the
  // first zero, because the newest force is zero only for some ticks.
  std::size_t zero = before;
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    while (zero < log_->size() && (*log_)[zero].magnitude > 0.0) ++zero;
    return zero < log_->size();
  }));
  // The event reaches the window some ticks after it is sent: the force falls from there on.
  std::size_t last = zero;
  while (last > before && (*log_)[last - 1].magnitude < 0.99 * PushedDevice::maxForce) --last;
  EXPECT_LE(zero - last + 1, 5u);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return log_->size() > zero + 50 || !GetParam().goesOn; }));
  const double atStart = GetParam().goesOn ? 0.01 : 0.0;  // [N], twenty times the physical force
  for (std::size_t i = zero; i < log_->size(); ++i) ASSERT_LE((*log_)[i].magnitude, atStart) << i;
  EXPECT_EQ(window_->stage(), GetParam().stage);
}

INSTANTIATE_TEST_SUITE_P(OfTheBooth, EveryWayToLeave, testing::ValuesIn(leaves),
                         [](const auto& leave) { return std::string(leave.param.name); });

TEST_F(BoothDevice, HasAStopButtonWithWholeTextOnASmallGermanScreen)
{
  gui::useLanguage(*QCoreApplication::instance(), "de");
  push();
  if (HasFatalFailure()) return;
  window_->setFixedSize(1024, 640);
  for (int i = 0; i < 8; ++i) QCoreApplication::processEvents();  // nested layouts
  const auto* stop = window_->findChild<QAbstractButton*>("stopButton");
  ASSERT_NE(stop, nullptr);
  EXPECT_TRUE(stop->isVisible());
  EXPECT_GE(stop->width(), 400);  // half the booth's width: found without looking for it
  keepPicture(*window_, "kiosk-stop-de");
  for (const std::string& text : cutTextsOf(*window_)) ADD_FAILURE() << text;
  press(*window_, "stopButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return log_->newest() == 0.0; }));
  keepPicture(*window_, "kiosk-stopped-de");
  gui::useLanguage(*QCoreApplication::instance(), "en");
  QLocale::setDefault(QLocale::c());
}

TEST_F(BoothDevice, GoesOnAfterAStopWhenTheScreenIsTouched)
{
  push();
  if (HasFatalFailure()) return;
  press(*window_, "stopButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return window_->control().isStopped(); }));
  press(*window_, "stopButton");  // once more changes nothing
  ASSERT_TRUE(WindowRig::waitUntil([&] { return log_->newest() == 0.0; }));
  EXPECT_TRUE(window_->control().isStopped());
  QTest::mouseClick(window_->findChild<QWidget*>("kioskTitle"), Qt::LeftButton);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return log_->newest() > 0.0; }));
}

}  // namespace
}  // namespace perilymph::test
