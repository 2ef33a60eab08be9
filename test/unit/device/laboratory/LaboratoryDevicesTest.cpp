// SPDX-License-Identifier: BSD-3-Clause

// What holds for every device of a laboratory: positions, forces, buttons, rate, and what is left of
// the force when something fails.

#include <csignal>
#include <filesystem>

#include "LaboratoryRig.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"

namespace perilymph::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::HasSubstr;

/// Child processes of a process.
std::vector<pid_t> childrenOf(const std::string& process)
{
  std::vector<pid_t> found;
  for (const auto& task : std::filesystem::directory_iterator("/proc/" + process + "/task")) {
    std::ifstream file(task.path() / "children");
    for (pid_t id = 0; file >> id;) found.push_back(id);
  }
  return found;
}

class ALaboratoryDevice : public LaboratoryRig,
                          public testing::WithParamInterface<LaboratoryDevice> {
protected:
  void SetUp() override { use(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Of, ALaboratoryDevice, testing::ValuesIn(laboratoryDevices()),
                         [](const auto& device) { return std::string(device.param.name); });

TEST_P(ALaboratoryDevice, StatesWhatIsPublishedOfIt)
{
  ASSERT_NO_FATAL_FAILURE(load());
  const device::DeviceTraits traits = device_->traits();
  EXPECT_EQ(traits.name, GetParam().shown);
  EXPECT_EQ(traits.maxForce, GetParam().maxForce);
  EXPECT_EQ(traits.actuatedTranslations, 3);
  EXPECT_GE(traits.buttons, 1);
}

TEST_P(ALaboratoryDevice, ThatIsAbsentIsRefusedWithOneSentence)
{
  state().fault = PeerState::absent;
  const std::string sentence = refusal();
  EXPECT_THAT(sentence, HasSubstr(GetParam().absent));
  EXPECT_TRUE(isOneSentence(sentence)) << sentence;
}

TEST_P(ALaboratoryDevice, IsValidFromTheFirstTick)
{
  // A sample that is not valid ends an insertion with a fault.
  for (int i = 0; i < 5; ++i) {
    ASSERT_NO_FATAL_FAILURE(open());
    EXPECT_EQ(device_->read().isValid, 1u);
    device_->close();
  }
}

TEST_P(ALaboratoryDevice, IsWhereTheHandHoldsIt)
{
  ASSERT_NO_FATAL_FAILURE(open());
  for (const Vector3 place :
       {Vector3{0.0, 0.0, 0.0}, Vector3{0.02, 0.0, 0.0}, Vector3{0.0, 0.02, 0.0},
        Vector3{0.0, 0.0, -0.02}, Vector3{-0.01, 0.015, 0.02}}) {
    peer_->moveHand(place);
    const auto isThere = [&] {
      for (std::size_t i = 0; i < 3; ++i)
        if (!(std::fabs(newest_.position_D[i] - place[i]) <= GetParam().quantum)) return false;
      return newest_.isValid != 0 && newest_.sequence > 0;
    };
    EXPECT_TRUE(tickUntil({}, isThere))
        << newest_.position_D[0] << ' ' << newest_.position_D[1] << ' ' << newest_.position_D[2];
  }
}

TEST_P(ALaboratoryDevice, PushesTheHandWithTheForceOfTheProgram)
{
  ASSERT_NO_FATAL_FAILURE(open());
  for (const Vector3 place : {Vector3{0.0, 0.0, 0.0}, Vector3{0.02, -0.015, 0.01}}) {
    peer_->moveHand(place);
    for (const Vector3 force : {Vector3{0.5, 0.0, 0.0}, Vector3{0.0, 0.5, 0.0},
                                Vector3{0.0, 0.0, 0.5}, Vector3{-0.4, 0.3, -0.8}}) {
      const auto isFelt = [&] {
        for (std::size_t i = 0; i < 3; ++i)
          if (!(std::fabs(state().force[i] - force[i]) <= GetParam().forceQuantum)) return false;
        return true;
      };
      EXPECT_TRUE(tickUntil(force, isFelt)) << state().force[0] << ' ' << state().force[1] << ' '
                                            << state().force[2] << " for " << force[0];
    }
  }
}

TEST_P(ALaboratoryDevice, RendersNoMoreThanItsPublishedMaximum)
{
  ASSERT_NO_FATAL_FAILURE(open());
  const double limit = GetParam().maxForce;
  EXPECT_TRUE(tickUntil({0.0, 0.0, 100.0}, [&] { return peer_->force() > 0.99 * limit; }));
  tickFor({0.0, 0.0, 100.0}, milliseconds(100));
  for (std::size_t i = 0; i < state().count; ++i)
    EXPECT_LE(state().log[i].magnitude, limit + GetParam().forceQuantum);
}

TEST_P(ALaboratoryDevice, SeesItsButtonPressedAndReleased)
{
  ASSERT_NO_FATAL_FAILURE(open());
  for (const unsigned pressed : {1u, 0u, 1u, 0u}) {
    state().buttons = pressed;
    EXPECT_TRUE(tickUntil({}, [&] { return newest_.sequence > 0 && newest_.buttons == pressed; }));
  }
}

TEST_P(ALaboratoryDevice, SendsFreshSamplesAtItsRate)
{
  ASSERT_NO_FATAL_FAILURE(open());
  tickFor({}, milliseconds(2500));
  device_->health();
  const auto health = device_->health();
  const double nominal = 1.0 / device_->traits().nominalPeriod;
  std::cout << GetParam().name << ": " << health->reading.rate << " samples/s of " << nominal
            << ", median " << 1e3 * health->reading.intervalMedian << " ms\n";
  // A busy machine may read some too late; a device that is read at half its rate has lost every
  // second one.
  EXPECT_GT(health->reading.rate, 0.5 * nominal);
  EXPECT_LT(health->reading.rate, 1.2 * nominal);
}

TEST_P(ALaboratoryDevice, ThatIsUnpluggedEndsWithOneSentenceAndNoForce)
{
  ASSERT_NO_FATAL_FAILURE(push());
  state().fault = PeerState::unplugged;
  EXPECT_TRUE(tickUntil(pushed, [this] { return newest_.isValid == 0; }));
  EXPECT_TRUE(tickUntil(pushed, [this] { return !error().empty(); }));
  EXPECT_THAT(error(), HasSubstr(GetParam().shown));
  EXPECT_THAT(error(), HasSubstr("The force is off."));
  const std::size_t unplugged = state().count;
  // Plugged in again, it is told no force until it is opened, and then zero first.
  state().fault = PeerState::none;
  tickFor(pushed, milliseconds(200));
  for (std::size_t i = unplugged; i < state().count; ++i) EXPECT_EQ(state().log[i].magnitude, 0.0);
  device_->close();
  const std::size_t closed = state().count;
  ASSERT_NO_FATAL_FAILURE(push());
  ASSERT_GT(state().count, closed);
  EXPECT_EQ(state().log[closed].magnitude, 0.0);
  EXPECT_EQ(error(), "");
}

TEST_P(ALaboratoryDevice, ThatAnswersNothingHasNoForceOnceItAnswers)
{
  ASSERT_NO_FATAL_FAILURE(push());
  const std::size_t before = state().count;
  state().fault = PeerState::silent;
  EXPECT_TRUE(tickUntil(pushed, [this] { return !error().empty(); }));
  EXPECT_THAT(error(), HasSubstr("has sent nothing"));
  const std::size_t during = state().count;
  // Commands that it still takes are zero but for the last few under way.
  for (std::size_t i = before + 3; i < during; ++i) EXPECT_EQ(state().log[i].magnitude, 0.0) << i;
  // The device has zero before it renders a force again: as the last command of the silence, or, where
  // a library hangs and no command reaches it, after one that was under way.
  tickFor(pushed, milliseconds(100));
  state().fault = PeerState::none;
  EXPECT_TRUE(tickUntil(pushed, [&] { return state().count > during + 1; }));
  EXPECT_EQ(std::min({state().log[during - 1].magnitude, state().log[during].magnitude,
                      state().log[during + 1].magnitude}),
            0.0);
  // And the program feels its way back.
  EXPECT_TRUE(tickUntil(pushed, [this] { return peer_->force() > 0.4; }));
}

TEST_P(ALaboratoryDevice, IsLeftWithoutForceWhenItIsClosed)
{
  ASSERT_NO_FATAL_FAILURE(push());
  device_->close();
  EXPECT_TRUE(waitUntil([this] { return state().closed == state().opened; }, seconds(10)));
  EXPECT_EQ(peer_->force(), 0.0);
  EXPECT_EQ(state().log[state().count - 1].magnitude, 0.0);
}

TEST_P(ALaboratoryDevice, IsLeftWithoutForceByAProgramThatSendsNaN)
{
  ASSERT_NO_FATAL_FAILURE(push());
  EXPECT_TRUE(tickUntil({0.0, std::nan(""), 0.0}, [this] { return peer_->force() == 0.0; }));
}

TEST_P(ALaboratoryDevice, IsLeftWithoutForceWhenItsProcessCrashes)
{
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "The sanitizer handles the signal of the plug-in's process.";
#endif
  ASSERT_NO_FATAL_FAILURE(push());
  const auto hosts = childrenOf("self");
  ASSERT_EQ(hosts.size(), 1u);
  ::kill(hosts[0], SIGSEGV);
  EXPECT_TRUE(tickUntil(pushed, [this] { return !device_->health()->isConnected; }));
  EXPECT_TRUE(waitUntil([this] { return peer_->force() == 0.0; }, seconds(10)));
}

/// A program that pushes through the plug-in until something ends it.
class ALaboratoryDeviceOfAProgram : public ALaboratoryDevice {
protected:
  void startPushing()
  {
    program_ = std::make_unique<ChildProcess>(
        ProgramCall{testProgram("plugin_hand"), {peer_->library()}, {}, std::nullopt});
    ASSERT_TRUE(waitUntil([this] { return peer_->force() > 0.4; }, seconds(30)));
  }
  std::unique_ptr<ChildProcess> program_;
};

INSTANTIATE_TEST_SUITE_P(Of, ALaboratoryDeviceOfAProgram, testing::ValuesIn(laboratoryDevices()),
                         [](const auto& device) { return std::string(device.param.name); });

TEST_P(ALaboratoryDeviceOfAProgram, IsLeftWithoutForceWhenTheProgramIsKilled)
{
  ASSERT_NO_FATAL_FAILURE(startPushing());
  program_->send(SIGKILL);
  EXPECT_TRUE(waitUntil([this] { return state().closed == state().opened; }, seconds(10)));
  EXPECT_EQ(peer_->force(), 0.0);
}

TEST_P(ALaboratoryDeviceOfAProgram, HasNoForceWhileTheProgramIsStopped)
{
  ASSERT_NO_FATAL_FAILURE(startPushing());
  program_->send(SIGSTOP);
  EXPECT_TRUE(waitUntil([this] { return peer_->force() == 0.0; }, seconds(10)));
  const std::uint64_t exchanges = state().exchanges;
  EXPECT_TRUE(waitUntil([&] { return state().exchanges > exchanges + 50; }, seconds(10)));
  EXPECT_EQ(peer_->force(), 0.0);
  program_->send(SIGCONT);
  EXPECT_TRUE(waitUntil([this] { return peer_->force() > 0.4; }, seconds(10)));
}

}  // namespace
}  // namespace perilymph::test
