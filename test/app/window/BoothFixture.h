// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A booth with a clock that the test controls, and fingers on it.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QTest>

#include "KeptPicture.h"
#include "WindowRig.h"
#include "gui/kiosk/KioskWindow.h"
#include "gui/kiosk/SpeedPad.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

using gui::KioskStage;

inline const QDate aDay(2026, 11, 20);

/// A booth with a clock that the test controls.
class Booth : public testing::Test {
protected:
  void open(const session::Overrides& overrides = {}, const char* name = "contour-published")
  {
    auto scenario = session::loadScenario(name, overrides);
    ASSERT_TRUE(scenario) << scenario.error().message;
    gui::KioskClock clock;
    clock.seconds = [this] { return seconds_; };
    clock.today = [] { return QDateTime(aDay, QTime(14, 3, 21)); };
    window_ = std::make_unique<gui::KioskWindow>(*scenario, boardFile(), clock,
                                                 WindowRig::sharedCochleae());
    window_->show();
    const auto opened = window_->open();
    ASSERT_TRUE(opened) << opened.error().message;
    ASSERT_TRUE(WindowRig::waitUntil([&] { return travel_mm() > 0.0; }));
  }

  std::filesystem::path boardFile() const { return folder_.path() / "booth" / "board.txt"; }
  double travel_mm() const
  {
    return inMillimeters(Length::fromSi(window_->control().now().output.travel));
  }
  /// Processes events at the current time of the clock.
  bool framesPass()
  {
    const std::uint64_t end = window_->frames() + 3;
    return WindowRig::waitUntil([&] { return window_->frames() >= end; });
  }
  bool waitUntil(KioskStage stage)
  {
    return WindowRig::waitUntil([&] { return window_->stage() == stage; });
  }
  gui::SpeedPad& pad() { return *window_->findChild<gui::SpeedPad*>(); }
  QString label(const char* name)
  {
    return window_->findChild<QLabel*>(QLatin1String(name))->text();
  }
  void click(const char* name)
  {
    QTest::mouseClick(window_->findChild<QAbstractButton*>(QLatin1String(name)), Qt::LeftButton);
  }
  /// Puts a finger on the pad, near its fast end.
  void pressPad()
  {
    QTest::mousePress(&pad(), Qt::LeftButton, {}, QPoint(pad().width() - 40, pad().height() / 2));
  }
  void releasePad() { QTest::mouseRelease(&pad(), Qt::LeftButton); }

  TemporaryFolder folder_;
  double seconds_ = 1000.0;
  std::unique_ptr<gui::KioskWindow> window_;
};

}  // namespace perilymph::test
