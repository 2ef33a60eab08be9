// SPDX-License-Identifier: BSD-3-Clause

// The seven ways in which the window stops a device, with each device of a laboratory at the far end
// of its library: from the stop until the device itself was told zero.

#include <gtest/gtest.h>

#include "FlatWallScene.h"
#include "LaboratoryPeer.h"
#include "StopCalls.h"
#include "perilymph/device/PluginDevice.h"
#include "perilymph/session/Csv.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

using hidstack::stopCalls;
using hidstack::stopWays;
using std::chrono::seconds;

class ALaboratoryDeviceInTheWindow : public testing::TestWithParam<LaboratoryDevice> {
protected:
  void SetUp() override
  {
    // As in test/hidstack: a stiff rod against a flat wall, so that the hand feels the coupling.
    constexpr double scale = 20.0;
    auto scenario = session::loadScenario(
        "contour-published",
        {{"force_scale", session::shortestDecimal(scale)},
         {"coupling_stiffness_N_m", session::shortestDecimal(hidstack::couplingStiffness / scale)},
         {"coupling_damping_N_s_m", session::shortestDecimal(1.0 / scale)}});
    ASSERT_TRUE(scenario) << scenario.error().message;
    auto anatomy = session::buildAnatomy(*scenario);
    ASSERT_TRUE(anatomy) << anatomy.error().message;
    control_ = std::make_unique<gui::InsertionControl>(*scenario, std::nullopt);
    control_->disableRecording();
    control_->use(*scenario, gui::InsertionControl::Parts{*anatomy, hidstack::flatWallModel()});
    control_->choose([this] { return device::loadPluginDevice(peer_.library()); });
  }
  void TearDown() override { control_.reset(); }

  template <class Condition>
  [[nodiscard]] bool waitUntilShown(Condition holds)
  {
    return waitUntil(
        [&] {
          control_->update();
          return holds();
        },
        seconds(30));
  }

  /// Inserts until the hand feels at least 2 N: 30 mm suffice for the softest coupling, the Falcon's with
  /// 83 N/m.
  void push()
  {
    peer_.state().buttons = 0;
    peer_.moveHand({});
    const auto prepared = control_->prepare(gui::InputSource::device);
    ASSERT_TRUE(prepared) << prepared.error().message;
    const auto begun = control_->begin();
    ASSERT_TRUE(begun) << begun.error().message;
    // Only a button that is seen released while it is armed grasps when it is pressed.
    ASSERT_TRUE(waitUntilShown(
        [this] { return control_->now().output.workflow == haptics::Workflow::armed; }));
    const std::uint64_t armed = peer_.state().exchanges;
    ASSERT_TRUE(waitUntilShown([&] { return peer_.state().exchanges > armed + 20; }));
    peer_.state().buttons = 1;
    ASSERT_TRUE(waitUntilShown(
        [this] { return control_->now().output.workflow == haptics::Workflow::inserting; }));
    peer_.moveHand({0.0, 0.0, -0.030});
    ASSERT_TRUE(waitUntilShown([this] { return peer_.force() > 2.0; })) << peer_.force();
  }

  LaboratoryPeer peer_{GetParam()};
  std::unique_ptr<gui::InsertionControl> control_;
};

INSTANTIATE_TEST_SUITE_P(Of, ALaboratoryDeviceInTheWindow, testing::ValuesIn(laboratoryDevices()),
                         [](const auto& device) { return std::string(device.param.name); });

TEST_P(ALaboratoryDeviceInTheWindow, IsToldZeroInEveryWayToStop)
{
  for (std::size_t way = 0; way < stopWays.size(); ++way) {
    SCOPED_TRACE(stopWays[way]);
    ASSERT_NO_FATAL_FAILURE(push());
    PeerState& device = peer_.state();
    gui::SafetyStop safety(*control_);
    const std::size_t before = device.count;
    const bool isLater = std::string(stopWays[way]) == "focus_away";
    const std::int64_t due =
        monotonic() + (isLater ? static_cast<std::int64_t>(1e9 * hidstack::focusTime) : 0);
    stopCalls[way](*control_, safety);
    // The window's thread does nothing but wait. A busy machine may take the force away for a moment before.
    ASSERT_TRUE(waitUntil([&] { return monotonic() >= due; }, seconds(10)));
    // A force may be zero for a moment before the stop takes effect: only one that stays counts.
    constexpr std::int64_t stays = 50'000'000;  // [ns]
    std::int64_t since = monotonic();
    ASSERT_TRUE(waitUntil(
        [&] {
          if (peer_.force() != 0.0) since = monotonic();
          return monotonic() - since > stays;
        },
        seconds(10)));
    const std::size_t zero = device.count - 1;
    const bool isOver = std::string(stopWays[way]) == "quit";
    if (!isOver) {
      ASSERT_TRUE(waitUntil([&] { return device.count > zero + 100; }, seconds(10)));
    }
    std::size_t last = before;  // with a force
    for (std::size_t i = before; i < device.count; ++i)
      if (device.log[i].magnitude > 0.0) last = i;
    const double late_ms = 1e-6 * static_cast<double>(device.log[last].time - due);
    std::cout << GetParam().name << ' ' << stopWays[way] << ": last force after " << late_ms
              << " ms\n";
    EXPECT_LE(last, zero) << "The force came back.";
    // The loop has 5 ms; a machine without real-time priority that compiles beside it has more.
    EXPECT_LT(late_ms, 250.0);
    if (isLater) {
      EXPECT_GT(late_ms, -900.0) << "It ended when the focus left, not a second later.";
    }
    // Closed, as the window does before another device.
    const auto closed = control_->prepare(gui::InputSource::scripted);
    ASSERT_TRUE(closed) << closed.error().message;
  }
}

TEST_P(ALaboratoryDeviceInTheWindow, IsToldZeroWhenItsButtonIsReleased)
{
  ASSERT_NO_FATAL_FAILURE(push());
  peer_.state().buttons = 0;
  EXPECT_TRUE(waitUntilShown([this] { return peer_.force() == 0.0; }));
  EXPECT_TRUE(waitUntilShown(
      [this] { return control_->now().output.workflow == haptics::Workflow::paused; }));
}

TEST_P(ALaboratoryDeviceInTheWindow, InsertsAgainAfterItWasUnplugged)
{
  ASSERT_NO_FATAL_FAILURE(push());
  peer_.state().fault = PeerState::unplugged;
  EXPECT_TRUE(waitUntilShown(
      [this] { return control_->now().output.workflow == haptics::Workflow::fault; }));
  EXPECT_TRUE(waitUntilShown([this] {
    const auto health = control_->deviceHealth();
    return health && !health->error.empty();
  }));
  peer_.state().fault = PeerState::none;
  push();  // Reset, then Start
}

}  // namespace
}  // namespace perilymph::test
