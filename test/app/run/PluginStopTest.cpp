// SPDX-License-Identifier: BSD-3-Clause

// An installed plug-in in the window's control: it is chosen by its name, and each of the window's
// seven ways to stop takes the force away at the device's own end.

#include <gtest/gtest.h>
#include <unistd.h>

#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "ListeningDevice.h"
#include "gui/run/InputChoice.h"
#include "gui/run/InsertionControl.h"
#include "gui/run/SafetyStop.h"
#include "perilymph/session/Scenario.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

using gui::InputSource;
using gui::InsertionControl;

constexpr int pluginPatience_ms = 60'000;

/// A way to stop, as the window calls it.
struct Way {
  const char* name;
  void (*go)(InsertionControl& control, gui::SafetyStop& safety);
  std::size_t ticks = 0;  ///< Before the force has to end: at least as many milliseconds.
  int zeros = 100;        ///< Forces of zero that follow at least.
};

constexpr Way ways[] = {
    {"Pause", [](InsertionControl& control, gui::SafetyStop&) { control.pause(); }},
    {"Escape", [](InsertionControl&, gui::SafetyStop& safety) { safety.stopDevice(); }},
    {"StopButton", [](InsertionControl&, gui::SafetyStop& safety) { safety.stopDevice(); }},
    {"PageLeft", [](InsertionControl&, gui::SafetyStop& safety) { safety.onPageHidden(); }},
    {"FocusAway", [](InsertionControl&, gui::SafetyStop& safety) { safety.loseKeyboard(); },
     std::size_t(1e3 * gui::focusPatience.si())},
    {"ScreenLocked", [](InsertionControl&, gui::SafetyStop& safety) { safety.stopDevice(); }},
    {"Quit", [](InsertionControl&, gui::SafetyStop& safety) { safety.end(); }, 0, 1},
};

session::Scenario pushingScenario()
{
  const auto read =
      session::loadScenario("contour-published", {{"nodes", "40"}, {"force_scale", "20"}});
  EXPECT_TRUE(read) << read.error().message;
  return *read;
}

/// A plug-in that is installed for the user, whose device moves inward and listens at a socket.
class InstalledPluginThatPushes : public testing::TestWithParam<Way> {
protected:
  InstalledPluginThatPushes()
  {
    const auto plugins = home_ / "perilymph" / "plugins";
    std::filesystem::create_directories(plugins);
    std::filesystem::copy_file(testPlugin("socket_device"), plugins / "lab.so");
    ::setenv("XDG_DATA_HOME", home_.path().c_str(), 1);
    ::setenv("PERILYMPH_TEST_SOCKET", name_.c_str(), 1);
    ::setenv("PERILYMPH_TEST_FAULT", "none but it moves", 1);
  }
  ~InstalledPluginThatPushes() override
  {
    for (const char* name : {"XDG_DATA_HOME", "PERILYMPH_TEST_SOCKET", "PERILYMPH_TEST_FAULT"})
      ::unsetenv(name);
  }

  bool waitForWindow(const std::function<bool()>& claim)
  {
    return QTest::qWaitFor(
        [&] {
          control_.update();
          return claim();
        },
        pluginPatience_ms);
  }

  const TemporaryFolder home_;
  const std::string name_ = "perilymph-plugin-stop-" + std::to_string(::getpid());
  ListeningDevice listener_{name_};
  InsertionControl control_{pushingScenario(), home_ / "it.insertion"};
  gui::SafetyStop safety_{control_};
};

TEST_P(InstalledPluginThatPushes, EndsWithoutForce)
{
  ASSERT_TRUE(listener_.isThere());
  control_.choose(gui::inputNamed("Socket handle"));
  const auto prepared = control_.prepare(InputSource::device);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(control_.inputName(), "Socket handle");
  ASSERT_TRUE(control_.begin());
  // The wall pushes back on the array.
  ASSERT_TRUE(waitForWindow([this] { return std::fabs(listener_.force()) > 0.05; }));

  const std::size_t received = listener_.forces().size();
  GetParam().go(control_, safety_);
  // The window's thread does nothing more: neither its timer nor update() runs. The loop goes on and
  // writes zero, if it does not end.
  const Way& way = GetParam();
  EXPECT_TRUE(waitUntil([&] {
    const auto forces = listener_.forces();
    const auto last = forces.end() - std::min<std::ptrdiff_t>(std::ssize(forces), way.zeros);
    return forces.size() >= received + way.ticks + std::size_t(way.zeros) &&
           std::all_of(last, forces.end(), [](double force) { return force == 0.0; });
  }));
  EXPECT_EQ(listener_.force(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(InEveryWay, InstalledPluginThatPushes, testing::ValuesIn(ways),
                         [](const auto& way) { return std::string(way.param.name); });

}  // namespace
}  // namespace perilymph::test
