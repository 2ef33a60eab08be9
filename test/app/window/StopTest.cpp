// SPDX-License-Identifier: BSD-3-Clause

// Every way to stop takes the force of a device away, though the window's thread is blocked and the
// queue of commands is full.

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>

#include "HeldUpLoop.h"
#include "PushedDevice.h"
#include "WindowRig.h"
#include "gui/run/SafetyStop.h"
#include "perilymph/realtime/Pacer.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

using haptics::Workflow;

constexpr std::int64_t millisecond = 1'000'000;  // [ns]

/// Tells a held up loop that an event of a type reaches the application, before anything sees it.
class Hearing : public QObject {
public:
  Hearing(QEvent::Type type, HeldUpLoop& loop) : type_(type), loop_(loop)
  {
    qApp->installEventFilter(this);
  }
  bool eventFilter(QObject*, QEvent* event) override
  {
    if (event->type() == type_) loop_.setTone();
    return false;
  }

private:
  QEvent::Type type_;
  HeldUpLoop& loop_;
};

/// A way to stop, as the user or the system does it.
struct Way {
  const char* name;
  QEvent::Type event;
  void (*go)(WindowRig&);
  std::int64_t delay = 0;  // from the event to the moment at which the force has to end [ns]
};

const Way ways[] = {
    {"Pause", QEvent::MouseButtonRelease, [](WindowRig& rig) { rig.click("startButton"); }},
    {"Space", QEvent::KeyPress, [](WindowRig& rig) { rig.pressKey(Qt::Key_Space); }},
    {"Esc", QEvent::KeyPress, [](WindowRig& rig) { rig.pressKey(Qt::Key_Escape); }},
    {"Esc in a field of the panel", QEvent::KeyPress,
     [](WindowRig& rig) {
       auto* field = rig.window().findChild<QWidget*>(QStringLiteral("panelForceScale"));
       ASSERT_NE(field, nullptr);
       QTest::keyClick(field, Qt::Key_Escape);
     }},
    {"Stop button", QEvent::MouseButtonPress, [](WindowRig& rig) { rig.click("stopButton"); }},
    {"page left", QEvent::MouseButtonRelease,
     [](WindowRig& rig) { rig.click("sessionsPageButton"); }},
    {"focus away", QEvent::WindowDeactivate,
     [](WindowRig& rig) {
       QEvent away(QEvent::WindowDeactivate);
       QApplication::sendEvent(&rig.window(), &away);
     },
     1000 * millisecond},
    {"window closed", QEvent::Close, [](WindowRig& rig) { rig.window().close(); }},
};

class AForceOfTheWindow : public testing::Test {
protected:
  /// Inserts until the device is told its largest force.
  void push()
  {
    rig_ = std::make_unique<WindowRig>(session::Overrides{{"force_scale", "20"},
                                                          {"friction_static", "0.3"},
                                                          {"friction_dynamic", "0.3"},
                                                          {"nodes", "40"}});
    rig_->window().insertion().useDevice([this] {
      return Result<std::unique_ptr<device::HapticDevice>>(std::make_unique<PushedDevice>(log_));
    });
    ASSERT_EQ(rig_->window().control().inputName(), "Pushed device");
    // Shown fifteen times a second.
    ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->button("stopButton").isVisible(); }));
    rig_->click("startButton");
    ASSERT_TRUE(
        WindowRig::waitUntil([&] { return rig_->now().output.workflow == Workflow::inserting; }));
    log_->isPushed = true;
    ASSERT_TRUE(WindowRig::waitUntil([&] { return isLargest(log_->newest()); }));
    ASSERT_TRUE(
        WindowRig::waitUntil([&] { return rig_->button("startButton").text() == "Pause"; }));
    ASSERT_TRUE(isLargest(log_->newest()));
  }
  static bool isLargest(double magnitude) { return magnitude > 0.99 * PushedDevice::maxForce; }

  /// Fills the loop's queue of commands.
  void fillQueue()
  {
    // The window sends at most one command per snapshot, too few to fill the queue.
    auto& control = const_cast<gui::InsertionControl&>(rig_->window().control());
    while (control.ask(haptics::Command::Kind::none)) continue;
  }

  /// The window's thread does nothing until the device was told forces for a time.
  void block(std::int64_t until)
  {
    ASSERT_TRUE(
        waitUntil([&] { return log_->size() > 0 && (*log_)[log_->size() - 1].time > until; },
                  std::chrono::seconds(30)));
  }
  const std::shared_ptr<ForceLog> log_ = std::make_shared<ForceLog>();
  std::unique_ptr<WindowRig> rig_;
};

class EveryWayToStop : public AForceOfTheWindow, public testing::WithParamInterface<Way> {};

TEST_P(EveryWayToStop, TakesTheLargestForceAwayWithinFiveTicksThoughTheQueueIsFull)
{
  const Way& way = GetParam();
  push();
  if (HasFatalFailure()) return;
  HeldUpLoop loop(log_);
  const Hearing hearing(way.event, loop);
  ASSERT_TRUE(loop.begin());
  fillQueue();
  way.go(*rig_);
  ASSERT_NE(loop.heardAt(), 0) << "The window did not hear " << way.name;
  const std::int64_t due = loop.heardAt() + way.delay;
  ASSERT_TRUE(
      rig_->window().isVisible());  // one that closes asks first, as the insertion is unfinished
  ASSERT_TRUE(loop.block(due));
  loop.expectStop(way.name, due);
}

INSTANTIATE_TEST_SUITE_P(Of, EveryWayToStop, testing::ValuesIn(ways), [](const auto& way) {
  std::string name;
  for (const char* c = way.param.name; *c != 0; ++c)
    if (*c != ' ') name += *c;
  return name;
});

TEST_F(AForceOfTheWindow, ComesBackOnlyOnAskingAndThenFadesIn)
{
  push();
  rig_->click("stopButton");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig_->now().output.workflow == Workflow::paused; }));
  ASSERT_TRUE(rig_->runForTicks(300));
  EXPECT_EQ(log_->newest(), 0.0);
  EXPECT_TRUE(rig_->label("hintLabel").contains(QLatin1String("Stopped")));
  EXPECT_EQ(rig_->button("startButton").text(), "Start");

  const std::size_t asked = log_->size();
  rig_->click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return isLargest(log_->newest()); }));
  EXPECT_EQ(rig_->now().output.workflow, Workflow::inserting);
  // The physical force is about twice the clamp, and fades in over half a second.
  double before = 0.0;
  for (std::size_t i = asked; i < log_->size(); ++i) {
    EXPECT_LE((*log_)[i].magnitude - before, 0.02 * PushedDevice::maxForce) << i;
    before = (*log_)[i].magnitude;
  }
}

TEST_F(AForceOfTheWindow, StaysIfTheFocusComesBackWithinASecond)
{
  push();
  QEvent away(QEvent::WindowDeactivate), back(QEvent::WindowActivate);
  QApplication::sendEvent(&rig_->window(), &away);
  const std::int64_t left = realtime::monotonicNanoseconds();
  block(left + 300 * millisecond);
  QApplication::sendEvent(&rig_->window(), &back);
  block(left + 1300 * millisecond);
  EXPECT_TRUE(isLargest(log_->newest()));
}

TEST_F(AForceOfTheWindow, IsOfferedNoStopWhereThereIsNone)
{
  rig_ = std::make_unique<WindowRig>();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->button("startButton").isEnabled(); }));
  EXPECT_FALSE(rig_->button("stopButton").isVisible());
}

}  // namespace
}  // namespace perilymph::test
