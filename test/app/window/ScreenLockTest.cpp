// SPDX-License-Identifier: BSD-3-Clause

// A locked screen takes the force away: the services that announce it are played on a private bus.

#include <gtest/gtest.h>

#include <QDBusConnection>
#include <QDBusMessage>
#include <QSignalSpy>
#include <QTest>

#include "HeldUpLoop.h"
#include "PushedDevice.h"
#include "WindowRig.h"
#include "gui/program/ScreenLock.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using namespace std::chrono_literals;

/// A bus of its own, with a service that announces what it is told to.
class LockedScreen : public testing::Test {
protected:
  LockedScreen() : daemon_(call())
  {
    EXPECT_TRUE(daemon_.waitForOutput("unix:", 60s)) << "dbus-daemon did not start";
    const QString address = QString::fromStdString(socket());
    listener_ = QDBusConnection::connectToBus(address, QStringLiteral("listener"));
    service_ = QDBusConnection::connectToBus(address, QStringLiteral("service"));
    EXPECT_TRUE(listener_.isConnected());
    EXPECT_TRUE(service_.registerService(QStringLiteral("org.freedesktop.login1")));
    lock_ = std::make_unique<gui::ScreenLock>(listener_, listener_, nullptr);
  }
  ~LockedScreen() override
  {
    lock_.reset();
    QDBusConnection::disconnectFromBus(QStringLiteral("listener"));
    QDBusConnection::disconnectFromBus(QStringLiteral("service"));
  }
  std::string socket() const { return "unix:path=" + (folder_ / "bus").string(); }
  ProgramCall call() const
  {
    ProgramCall call;
    call.program = "dbus-daemon";
    call.arguments = {"--session", "--nofork", "--nopidfile", "--print-address",
                      "--address=" + socket()};
    return call;
  }

  void announce(const char* path, const char* interface, const char* signal,
                const QVariantList& arguments)
  {
    QDBusMessage message = QDBusMessage::createSignal(QLatin1String(path), QLatin1String(interface),
                                                      QLatin1String(signal));
    message.setArguments(arguments);
    EXPECT_TRUE(service_.send(message));
  }
  void announceHint(bool isLocked)
  {
    announce("/org/freedesktop/login1/session/_31", "org.freedesktop.DBus.Properties",
             "PropertiesChanged",
             {QStringLiteral("org.freedesktop.login1.Session"),
              QVariantMap{{QStringLiteral("LockedHint"), isLocked}}, QStringList{}});
  }
  void announceActive(const char* desktop, bool isActive)
  {
    const QByteArray interface = QByteArray("org.") + desktop + ".ScreenSaver";
    announce("/org/freedesktop/ScreenSaver", interface.constData(), "ActiveChanged", {isActive});
  }

  const TemporaryFolder folder_;
  ChildProcess daemon_;
  QDBusConnection listener_{QString()}, service_{QString()};
  std::unique_ptr<gui::ScreenLock> lock_;
};

TEST_F(LockedScreen, IsHeardFromLogind)
{
  QSignalSpy spy(lock_.get(), &gui::ScreenLock::locked);
  announce("/org/freedesktop/login1/session/_31", "org.freedesktop.login1.Session", "Lock", {});
  ASSERT_TRUE(WindowRig::waitUntil([&] { return spy.count() == 1; }));
  announceHint(true);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return spy.count() == 2; }));
}

TEST_F(LockedScreen, IsHeardFromTheScreenSaversOfTheDesktops)
{
  QSignalSpy spy(lock_.get(), &gui::ScreenLock::locked);
  int heard = 0;
  for (const char* desktop : {"freedesktop", "gnome", "cinnamon", "mate", "xfce"}) {
    announceActive(desktop, true);
    ++heard;
    EXPECT_TRUE(WindowRig::waitUntil([&] { return spy.count() == heard; })) << desktop;
  }
}

TEST_F(LockedScreen, IsNotHeardWhenTheScreenIsUnlocked)
{
  QSignalSpy spy(lock_.get(), &gui::ScreenLock::locked);
  announceActive("freedesktop", false);
  announceHint(false);
  announceHint(true);  // in order behind them
  ASSERT_TRUE(WindowRig::waitUntil([&] { return spy.count() > 0; }));
  EXPECT_EQ(spy.count(), 1);
}

TEST_F(LockedScreen, TakesTheForceOfADeviceAway)
{
  const auto log = std::make_shared<ForceLog>();
  WindowRig rig({{"force_scale", "20"},
                 {"friction_static", "0.3"},
                 {"friction_dynamic", "0.3"},
                 {"nodes", "40"}});
  rig.window().insertion().useDevice([&] {
    return Result<std::unique_ptr<device::HapticDevice>>(std::make_unique<PushedDevice>(log));
  });
  HeldUpLoop loop(log);
  QObject::connect(lock_.get(), &gui::ScreenLock::locked, &rig.window(),
                   [&loop] { loop.setTone(); });
  QObject::connect(lock_.get(), &gui::ScreenLock::locked, &rig.window().insertion(),
                   &gui::InsertionController::stopDevice);
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig.now().output.workflow == haptics::Workflow::inserting; }));
  log->isPushed = true;
  ASSERT_TRUE(WindowRig::waitUntil([&] { return log->newest() > 0.99 * PushedDevice::maxForce; }));
  ASSERT_TRUE(loop.begin());
  announceActive("freedesktop", true);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return loop.heardAt() != 0; }));
  ASSERT_TRUE(loop.block(loop.heardAt()));
  loop.expectStop("screen locked", loop.heardAt());
}

}  // namespace
}  // namespace perilymph::test
