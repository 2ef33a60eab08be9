// SPDX-License-Identifier: BSD-3-Clause

// The window as a server for navigation programs: off by default, on by its setting, and what its
// clients receive. For the program's option see NavigationCallTest.cpp.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <igtlPointMessage.h>
#include <igtlPolyDataMessage.h>
#include <igtlSensorMessage.h>
#include <igtlTransformMessage.h>

#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QTest>
#include <future>

#include "CutTexts.h"
#include "KeptPicture.h"
#include "WindowRig.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/program/Languages.h"
#include "gui/run/UserSettings.h"
#include "gui/shell/Navigation.h"
#include "gui/shell/OverlayStack.h"
#include "gui/widgets/Notice.h"
#include "perilymph/test/IgtlClient.h"
#include "perilymph/test/InetSockets.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;
using Position = std::array<float, 3>;

/// One of each message.
struct Received {
  Position tip, tweezers;
  int contacts = 0;
  Position firstContact;
  std::array<double, 4> force;
  unsigned int scalaTriangles = 0;
};

Position placeOf(igtl::TransformMessage& message)
{
  igtl::Matrix4x4 matrix;
  message.GetMatrix(matrix);
  return {matrix[0][3], matrix[1][3], matrix[2][3]};
}

Received receiveAll(int port)
{
  Received all;
  auto socket = igtl::ClientSocket::New();
  EXPECT_EQ(socket->ConnectToServer("127.0.0.1", port), 0);
  socket->SetReceiveTimeout(WindowRig::patience_ms);
  // It comes on connection. What is received in the end leaves nothing large behind: the library's
  // client does not close its socket, which stays until the server's bytes are taken.
  const auto scala = receive<igtl::PolyDataMessage>(*socket, "PerilymphScala");
  all.scalaTriangles = scala->GetPolygons()->GetNumberOfCells();
  receive<igtl::PolyDataMessage>(*socket, "PerilymphVestibuli");
  all.tip = placeOf(*receive<igtl::TransformMessage>(*socket, "PerilymphTip"));
  all.tweezers = placeOf(*receive<igtl::TransformMessage>(*socket, "PerilymphTweezers"));
  const auto contacts = receive<igtl::PointMessage>(*socket, "PerilymphContacts");
  all.contacts = contacts->GetNumberOfPointElement();
  igtl::PointElement::Pointer first;
  contacts->GetPointElement(0, first);
  first->GetPosition(all.firstContact.data());
  const auto force = receive<igtl::SensorMessage>(*socket, "PerilymphForce");
  for (unsigned int i = 0; i < 4; ++i) all.force[i] = force->GetValue(i);
  return all;
}

/// Receives while the window's events are processed.
Received receiveInTheMeantime(int port)
{
  auto received = std::async(std::launch::async, [port] { return receiveAll(port); });
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return received.wait_for(0s) == std::future_status::ready; }));
  return received.get();
}

void expectShown(const Received& received, const haptics::Snapshot& now)
{
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_FLOAT_EQ(received.tip[i], float(now.output.tip_W[i] * 1e3));
    EXPECT_FLOAT_EQ(received.tweezers[i], float(now.output.proxy_W[i] * 1e3));
    EXPECT_EQ(received.force[i], now.output.force_W[i]);
  }
  EXPECT_EQ(received.force[3], now.output.axialForce);
  EXPECT_GT(received.scalaTriangles, 1000u);
}

class NavigationSetting : public testing::Test {
protected:
  void SetUp() override { gui::UserSettings().remove("openigtlink"); }
  void TearDown() override { gui::UserSettings().remove("openigtlink"); }

  void open()
  {
    rig_ = std::make_unique<WindowRig>();
    rig_->window().sheets().toggleSettings();
  }
  int turnOn()
  {
    const int port = freePort();
    rig_->type("navigation-port", std::to_string(port).c_str());
    rig_->click("navigation-on");
    return port;
  }
  /// For the pictures.
  void scrollToSection()
  {
    auto* const line = rig_->window().findChild<QLabel*>("navigationStatus");
    for (QWidget* around = line; around != nullptr; around = around->parentWidget())
      if (auto* const area = qobject_cast<QScrollArea*>(around))
        area->ensureWidgetVisible(line, 0, 40);
  }
  std::string status() { return rig_->label("navigationStatus").toStdString(); }
  std::vector<InetSocket> sockets() { return inetSocketsOf(::getpid()); }
  static QString kept() { return gui::UserSettings().value("openigtlink/server").toString(); }

  std::unique_ptr<WindowRig> rig_;
};

TEST_F(NavigationSetting, IsOffByDefaultAndNothingListens)
{
  open();
  rig_->window().navigation().listenAsSet();
  ASSERT_TRUE(rig_->runForTicks(0));
  EXPECT_THAT(sockets(), IsEmpty());
  EXPECT_TRUE(rig_->button("navigation-off").isChecked());
  EXPECT_EQ(rig_->window().findChild<QLineEdit*>("navigation-port")->text(), "18944");
  EXPECT_EQ(status(), "OpenIGTLink is off: no program can connect.");
}

TEST_F(NavigationSetting, SendsWhatIsShownAndEndsWhenItIsTurnedOff)
{
  open();
  const int port = turnOn();
  ASSERT_EQ(sockets().size(), 1u);
  EXPECT_TRUE(sockets()[0].isListening);
  EXPECT_EQ(sockets()[0].place, loopback(port));
  EXPECT_EQ(status(), "OpenIGTLink on 127.0.0.1:" + std::to_string(port) + ", no client");
  EXPECT_EQ(rig_->window().notice().sentence().toStdString(), status());

  // into the cochlea, and at rest there
  rig_->window().insertion().start();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 2.0; }));
  EXPECT_TRUE(rig_->button("navigation-off").isEnabled());
  EXPECT_FALSE(rig_->button("look-light").isEnabled());
  rig_->window().insertion().pause();
  const auto shape = [&] { return rig_->now().output.tip_W; };
  auto before = shape();
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    const bool isSame = shape() == before && rig_->now().output.speed == 0.0;
    before = shape();
    return isSame && rig_->runForTicks(200) && shape() == before;
  }));
  const Received received = receiveInTheMeantime(port);
  expectShown(received, rig_->now());
  const auto& contacts = rig_->window().control().scenario().array().contactsFromTip;
  EXPECT_EQ(received.contacts, int(contacts.size()));
  double squared = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    squared += std::pow(received.firstContact[i] - received.tip[i], 2);
  // The array is nearly straight so close to its tip.
  EXPECT_NEAR(std::sqrt(squared), inMillimeters(contacts.front()), 0.02);

  igtl::ClientSocket::Pointer client = igtl::ClientSocket::New();
  ASSERT_EQ(client->ConnectToServer("127.0.0.1", port), 0);
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return status().find(", 1 client") != std::string::npos; }));
  rig_->click("navigation-off");
  EXPECT_EQ(kept(), "off");
  client->SetReceiveTimeout(WindowRig::patience_ms);
  std::array<char, 4096> bytes;
  while (client->Receive(bytes.data(), int(bytes.size()), 0) > 0) {
  }
  client->CloseSocket();
  EXPECT_THAT(sockets(), IsEmpty());
}

TEST_F(NavigationSetting, SendsTheReplayThatIsShown)
{
  const TemporaryFolder folder;
  const fs::path file = folder / "run.insertion";
  {
    WindowRig recorded({}, file);
    recorded.window().insertion().start();
    ASSERT_TRUE(recorded.runForTicks(300));
    recorded.window().close();
  }
  open();
  const int port = turnOn();
  rig_->window().replay(file);
  const auto& replay = rig_->window().insertion().replay();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return replay.isOpen() && replay.now().tick >= 250; }));
  rig_->window().insertion().replay().pause();
  int turns = 0;  // of the event loop: the picture that was due is shown
  ASSERT_TRUE(WindowRig::waitUntil([&] { return ++turns > 10; }));
  expectShown(receiveInTheMeantime(port), replay.now());
}

TEST_F(NavigationSetting, IsKeptAndAppliedByTheNextWindow)
{
  open();
  const int port = turnOn();
  EXPECT_EQ(kept(), "on");
  rig_.reset();
  EXPECT_THAT(sockets(), IsEmpty());
  open();
  EXPECT_THAT(sockets(), IsEmpty());  // the program decides, not the window
  rig_->window().navigation().listenAsSet();
  ASSERT_EQ(sockets().size(), 1u);
  EXPECT_EQ(sockets()[0].place, loopback(port));
  EXPECT_TRUE(rig_->button("navigation-on").isChecked());
}

TEST_F(NavigationSetting, SaysInOneSentenceThatThePortIsTaken)
{
  open();
  {
    const TakenPort taken;
    rig_->type("navigation-port", std::to_string(taken.number()).c_str());
    rig_->click("navigation-on");
    EXPECT_EQ(status(), "The port " + std::to_string(taken.number()) +
                            " at 127.0.0.1 is taken by another program. End that program, or "
                            "choose another port.");
    EXPECT_EQ(rig_->window().notice().sentence().toStdString(), status());
    EXPECT_EQ(sockets().size(), 1u);  // the test's own
  }
  EXPECT_TRUE(rig_->button("navigation-off").isChecked());
  EXPECT_EQ(kept(), "off");
  rig_->click("navigation-on");  // free again
  EXPECT_EQ(sockets().size(), 1u);
}

TEST_F(NavigationSetting, ShowsThatOtherComputersCanConnectToAnAddressOfTheCommandLine)
{
  open();
  EXPECT_EQ(rig_->button("navigation-on").text(), "on, for programs on this computer");
  ASSERT_TRUE(rig_->window().navigation().listen({"0.0.0.0", 0}));
  EXPECT_TRUE(rig_->button("navigation-on").isChecked());
  EXPECT_EQ(rig_->button("navigation-on").text(), "on, also for other computers");
  EXPECT_THAT(status(), testing::StartsWith("OpenIGTLink on 0.0.0.0:"));
  EXPECT_THAT(status(), HasSubstr("receives the insertion and the CT, without a password."));
  EXPECT_EQ(rig_->window().notice().sentence().toStdString(), status());
  EXPECT_TRUE(kept().isEmpty());
  rig_->click("navigation-off");
  EXPECT_THAT(sockets(), IsEmpty());
}

TEST_F(NavigationSetting, KeepsTheCoordinatesAndSendsNoneOfThePatientWithoutACt)
{
  open();
  EXPECT_TRUE(rig_->button("navigation-cochlea").isChecked());
  rig_->click("navigation-patient");
  EXPECT_TRUE(rig_->button("navigation-off").isChecked());
  const int port = turnOn();
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return status().find("Nothing is sent: the coordinates") != std::string::npos; }));
  EXPECT_EQ(rig_->window().notice().sentence().toStdString(), status());
  rig_.reset();
  open();
  rig_->window().navigation().listenAsSet();
  EXPECT_TRUE(rig_->button("navigation-patient").isChecked());
  rig_->click("navigation-cochlea");
  receiveInTheMeantime(port);
  EXPECT_THAT(status(), testing::Not(HasSubstr("Nothing is sent")));
}

TEST_F(NavigationSetting, RefusesAPortThatIsNone)
{
  open();
  for (const char* port : {"80", "70000", "port"}) {
    rig_->type("navigation-port", port);
    EXPECT_EQ(status(), "The port must be a number from 1024 to 65535.") << port;
    EXPECT_EQ(rig_->window().findChild<QLineEdit*>("navigation-port")->text(), "18944");
  }
  EXPECT_THAT(sockets(), IsEmpty());
}

TEST_F(NavigationSetting, KeepsAPortThatIsBeingTyped)
{
  open();
  const int port = turnOn();
  auto& field = *rig_->window().findChild<QLineEdit*>("navigation-port");
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, "20");
  auto client = igtl::ClientSocket::New();
  ASSERT_EQ(client->ConnectToServer("127.0.0.1", port), 0);
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return status().find(", 1 client") != std::string::npos; }));
  EXPECT_EQ(field.text(), "20");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(field.text(), QString::number(port));  // 20 is none
}

TEST_F(NavigationSetting, TellsOfAClientThatIsRefused)
{
  open();
  const int port = turnOn();
  auto client = igtl::ClientSocket::New();
  ASSERT_EQ(client->ConnectToServer("127.0.0.1", port), 0);
  const std::vector<char> nonsense(58, char(0xff));
  client->Send(nonsense.data(), int(nonsense.size()));
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return rig_->window().notice().sentence().contains("header has version 65535"); }));
}

TEST_F(NavigationSetting, CutsNoTextInBothLanguages)
{
  for (const char* language : {"en", "de"}) {
    gui::useLanguage(*QCoreApplication::instance(), language);
    open();
    const TakenPort taken;
    rig_->type("navigation-port", std::to_string(taken.number()).c_str());
    rig_->click("navigation-on");
    EXPECT_TRUE(WindowRig::waitUntil([&] { return cutTextsOf(rig_->window()).empty(); }));
    scrollToSection();
    keepPicture(rig_->window(), std::string("navigation-taken-") + language);
    turnOn();
    rig_->click("navigation-patient");
    EXPECT_TRUE(WindowRig::waitUntil(
        [&] { return rig_->window().navigation().broadcast().isWaitingForCt(); }));
    EXPECT_TRUE(WindowRig::waitUntil([&] { return cutTextsOf(rig_->window()).empty(); }));
    keepPicture(rig_->window(), std::string("navigation-patient-") + language);
    ASSERT_TRUE(rig_->window().navigation().listen({"0.0.0.0", 0}));
    EXPECT_TRUE(WindowRig::waitUntil([&] { return cutTextsOf(rig_->window()).empty(); }));
    keepPicture(rig_->window(), std::string("navigation-open-") + language);
    turnOn();
    EXPECT_TRUE(WindowRig::waitUntil([&] { return cutTextsOf(rig_->window()).empty(); }));
    keepPicture(rig_->window(), std::string("navigation-on-") + language);
    rig_.reset();
  }
  gui::useLanguage(*QCoreApplication::instance(), "en");
}

}  // namespace
}  // namespace perilymph::test
