// SPDX-License-Identifier: BSD-3-Clause

// What is left of the force when a plug-in, its process or the program fails.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "ListeningDevice.h"
#include "perilymph/device/PluginDevice.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

using device::HapticDevice;
using std::chrono::seconds;
using testing::HasSubstr;

constexpr double push = 0.5;  // [N]

/// How a process ends by a bad address before the host has its own handler.
#ifdef __SANITIZE_ADDRESS__
constexpr const char* crashed = "ended its process (status 1)";  // the sanitizer's handler
#else
constexpr const char* crashed = "crashed (signal 11)";
#endif

/// Child processes of this one, or of another.
std::vector<pid_t> children(const std::string& process = "self")
{
  std::vector<pid_t> found;
  for (const auto& task : std::filesystem::directory_iterator("/proc/" + process + "/task")) {
    std::ifstream file(task.path() / "children");
    for (pid_t id = 0; file >> id;) found.push_back(id);
  }
  return found;
}

/// It has ended, though perhaps nobody has waited for it.
bool hasEnded(pid_t id)
{
  std::ifstream file("/proc/" + std::to_string(id) + "/stat");
  std::string number, name, state;
  return !(file >> number >> name >> state) || state == "Z" || state == "X";
}

class PluginFault : public testing::Test {
protected:
  void SetUp() override
  {
    ASSERT_TRUE(listener_.isThere()) << "No socket to be had.";
    ::setenv("PERILYMPH_TEST_SOCKET", name_.c_str(), 1);
  }
  void TearDown() override { ::unsetenv("PERILYMPH_TEST_FAULT"); }

  void load(const std::string& fault = "none")
  {
    ::setenv("PERILYMPH_TEST_FAULT", fault.c_str(), 1);
    auto loaded = device::loadPluginDevice(testPlugin("socket_device"));
    ASSERT_TRUE(loaded) << loaded.error().message;
    device_ = *std::move(loaded);
  }

  /// One tick of a program that pushes.
  device::DeviceSample tick()
  {
    device_->await(milliseconds(2));
    const device::DeviceSample sample = device_->read();
    device_->write({{0.0, 0.0, push}, {}});
    return sample;
  }
  template <class Condition>
  void tickUntil(Condition holds)
  {
    EXPECT_TRUE(waitUntil([&] {
      tick();
      return holds();
    }));
  }

  /// Runs a plug-in with a fault from its first force on, until the device is lost.
  void runUntilLost(const std::string& fault)
  {
    load(fault);
    const auto opened = device_->open();
    ASSERT_TRUE(opened) << opened.error().message;
    tickUntil([this] { return listener_.hasReceived(push); });
    tickUntil([this] { return !device_->health()->isConnected; });
    EXPECT_EQ(tick().isValid, 0u);
    EXPECT_TRUE(waitUntil([this] { return listener_.isLeft(); }));
    EXPECT_EQ(listener_.force(), 0.0);
  }
  std::string error() { return device_->health()->error; }

  const std::string name_ = "perilymph-plugin-test-" + std::to_string(::getpid());
  ListeningDevice listener_{name_};
  std::unique_ptr<HapticDevice> device_;
};

/// Faults that reach the plug-in's process as a signal, or end it.
class PluginFaultWithSignals : public PluginFault {
protected:
  void SetUp() override
  {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "The thread sanitizer delays the signals of the plug-in's process.";
#endif
    PluginFault::SetUp();
  }
};

TEST_F(PluginFaultWithSignals, HangingInReadEndsWithZeroWritten)
{
  runUntilLost("hang in read");
  EXPECT_EQ(listener_.forces().back(), 0.0);
  EXPECT_THAT(error(), HasSubstr("socket_device.so did not return from read()"));
  EXPECT_THAT(error(), HasSubstr("The force is off."));
}

TEST_F(PluginFaultWithSignals, SpinningInReadEndsWithZeroWritten)
{
  runUntilLost("spin in read");
  EXPECT_EQ(listener_.forces().back(), 0.0);
  EXPECT_THAT(error(), HasSubstr("did not return from read()"));
}

TEST_F(PluginFaultWithSignals, HangingInWriteEndsTheProcessAndItsConnection)
{
  runUntilLost("hang in write");
  EXPECT_EQ(listener_.forces().back(), push);
  EXPECT_THAT(error(), HasSubstr("did not return from write()"));
}

TEST_F(PluginFaultWithSignals, BlockedByTheDeviceInWriteEndsTheProcessAndItsConnection)
{
  runUntilLost("block in write");
  EXPECT_THAT(error(), HasSubstr("did not return from write()"));
}

TEST_F(PluginFault, CrashingInReadEndsWithZeroWritten)
{
  runUntilLost("crash in read");
  EXPECT_EQ(listener_.forces().back(), 0.0);
  EXPECT_THAT(error(), HasSubstr("crashed (signal 11)"));
}

TEST_F(PluginFault, AbortingInReadEndsWithZeroWritten)
{
  runUntilLost("abort in read");
  EXPECT_EQ(listener_.forces().back(), 0.0);
  EXPECT_THAT(error(), HasSubstr("crashed (signal 6)"));
}

TEST_F(PluginFault, CrashingInWriteEndsTheProcessAndItsConnection)
{
  runUntilLost("crash in write");
  EXPECT_THAT(error(), HasSubstr("crashed (signal 11)"));
}

TEST_F(PluginFaultWithSignals, EndingItsProcessIsNoticed)
{
  runUntilLost("exit in read");
  EXPECT_THAT(error(), HasSubstr("ended its process (status 7)"));
}

TEST_F(PluginFault, ReturningNaNLeavesNoForceAndNoFreshSample)
{
  load("NaN from read");
  ASSERT_TRUE(device_->open());
  tickUntil([this] { return listener_.hasReceived(push); });
  tickUntil([this] { return listener_.force() == 0.0 && !error().empty(); });
  EXPECT_THAT(error(), HasSubstr("Socket handle sends values that are not numbers"));
  const std::uint64_t sequence = device_->read().sequence;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(tick().sequence, sequence);
  EXPECT_EQ(listener_.force(), 0.0);
  EXPECT_TRUE(device_->health()->isConnected);
}

TEST_F(PluginFault, StoppedAsAWholeIsEndedByTheProgram)
{
  load();
  ASSERT_TRUE(device_->open());
  tickUntil([this] { return listener_.hasReceived(push); });
  const auto hosts = children();
  ASSERT_EQ(hosts.size(), 1u);
  ::kill(hosts[0], SIGSTOP);
  tickUntil([this] { return !device_->health()->isConnected; });
  EXPECT_TRUE(waitUntil([this] { return listener_.isLeft(); }));
  EXPECT_THAT(error(), HasSubstr("did not answer and was ended"));
}

/// The process that a plug-in with the fault "leaves a child" started.
pid_t childOfHost()
{
  const auto hosts = children();
  EXPECT_EQ(hosts.size(), 1u);
  if (hosts.size() != 1) return 0;
  std::vector<pid_t> left;
  EXPECT_TRUE(waitUntil([&] { return !(left = children(std::to_string(hosts[0]))).empty(); }));
  return left.empty() ? 0 : left[0];
}

TEST_F(PluginFault, LeavingAChildEndsWithIt)
{
  load("leaves a child");
  ASSERT_TRUE(device_->open());
  const pid_t child = childOfHost();
  ASSERT_NE(child, 0);
  EXPECT_FALSE(hasEnded(child));
  device_.reset();
  EXPECT_TRUE(waitUntil([&] { return hasEnded(child); }));
}

TEST_F(PluginFault, LeavingAChildAndCrashingEndsWithIt)
{
  load("leaves a child");
  ASSERT_TRUE(device_->open());
  const pid_t child = childOfHost();
  ASSERT_NE(child, 0);
  ::kill(children().at(0), SIGKILL);
  tickUntil([this] { return !device_->health()->isConnected; });
  EXPECT_TRUE(waitUntil([&] { return hasEnded(child); }));
}

TEST_F(PluginFault, LostIsLoadedAgainWhenItIsOpened)
{
  runUntilLost("crash in read");
  ::setenv("PERILYMPH_TEST_FAULT", "none", 1);
  const auto opened = device_->open();
  ASSERT_TRUE(opened) << opened.error().message;
  tickUntil([this] { return listener_.force() == push; });
  EXPECT_EQ(error(), "");
}

TEST_F(PluginFaultWithSignals, CrashingWhileItIsLoadedIsARefusal)
{
  ::setenv("PERILYMPH_TEST_FAULT", "crash in create", 1);
  const auto loaded = device::loadPluginDevice(testPlugin("socket_device"));
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, HasSubstr(crashed));
}

TEST_F(PluginFault, CrashingWhileItIsOpenedIsAnError)
{
  load("crash in open");
  const auto opened = device_->open();
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, HasSubstr("crashed (signal 11)"));
}

TEST_F(PluginFault, ThatIsNoneEndsWithZeroWhenItIsClosed)
{
  load();
  ASSERT_TRUE(device_->open());
  tickUntil([this] { return listener_.force() == push; });
  device_->close();
  EXPECT_TRUE(waitUntil([this] { return listener_.isLeft(); }));
  EXPECT_EQ(listener_.forces().back(), 0.0);
  device_.reset();
  EXPECT_TRUE(children().empty());
}

TEST_F(PluginFault, OfTheProgramThatSendsNaNIsNoForce)
{
  load();
  ASSERT_TRUE(device_->open());
  tickUntil([this] { return listener_.force() == push; });
  const auto sent = listener_.forces().size();
  EXPECT_TRUE(waitUntil([&] {
    device_->await(milliseconds(2));
    device_->read();
    device_->write({{0.0, 0.0, std::nan("")}, {}});
    return listener_.forces().size() > sent + 20;
  }));
  EXPECT_EQ(listener_.force(), 0.0);
}

TEST_F(PluginFault, OfTheProgramThatSendsTooMuchIsLimited)
{
  load();
  ASSERT_TRUE(device_->open());
  EXPECT_TRUE(waitUntil([&] {
    device_->await(milliseconds(2));
    device_->read();
    device_->write({{0.0, 0.0, -80.0}, {}});
    return listener_.hasReceived(-1.0);
  }));
  const auto forces = listener_.forces();
  EXPECT_EQ(*std::min_element(forces.begin(), forces.end()), -1.0);
}

TEST_F(PluginFault, OfTheProgramThatTurnsTooMuchIsLimitedToTheStatedTorque)
{
  load();
  ASSERT_TRUE(device_->open());
  // 0.03 of 0.05 N.m passes as it is; 2 N.m is shortened; NaN becomes zero and leaves the force.
  for (const auto& [sent, written] : {std::pair{0.03, 0.03}, {2.0, 0.05}, {std::nan(""), 0.0}}) {
    EXPECT_TRUE(waitUntil([&] {
      device_->await(milliseconds(2));
      device_->read();
      device_->write({{0.0, 0.0, push}, {0.0, 0.0, sent}});
      const auto torques = listener_.torques();
      return listener_.force() == push && torques.back() == written;
    })) << sent;
  }
  const auto torques = listener_.torques();
  EXPECT_EQ(*std::max_element(torques.begin(), torques.end()), 0.05);
  device_->close();
  EXPECT_TRUE(waitUntil([this] { return listener_.isLeft(); }));
  EXPECT_EQ(listener_.torques().back(), 0.0);
}

TEST_F(PluginFault, WithoutOneAllocatesNothingInTheTick)
{
  if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();
  load();
  ASSERT_TRUE(device_->open());
  tick();
  const AllocationGuard guard;
  for (int i = 0; i < 300; ++i) tick();
  EXPECT_EQ(guard.allocations(), 0u);
}

/// A program that pushes through the plug-in until something ends it.
class PluginOfAProgram : public PluginFault {
protected:
  void startPushing(const std::string& fault = "none")
  {
    program_ = std::make_unique<ChildProcess>(ProgramCall{testProgram("plugin_hand"),
                                                          {testPlugin("socket_device")},
                                                          {{"PERILYMPH_TEST_FAULT", fault}},
                                                          std::nullopt});
    ASSERT_TRUE(waitUntil([this] { return listener_.hasReceived(push); }));
  }
  std::unique_ptr<ChildProcess> program_;
};

TEST_F(PluginOfAProgram, WritesZeroAndEndsWhenTheProgramIsKilled)
{
  startPushing();
  program_->send(SIGKILL);
  EXPECT_TRUE(waitUntil([this] { return listener_.isLeft(); }));
  EXPECT_EQ(listener_.forces().back(), 0.0);
}

TEST_F(PluginOfAProgram, EndsWithItsChildWhenTheProgramIsKilled)
{
  startPushing("leaves a child");
  const auto programs = children();
  ASSERT_EQ(programs.size(), 1u);
  const auto hosts = children(std::to_string(programs[0]));
  ASSERT_EQ(hosts.size(), 1u);
  const auto left = children(std::to_string(hosts[0]));
  ASSERT_EQ(left.size(), 1u);
  program_->send(SIGKILL);
  EXPECT_TRUE(waitUntil([this] { return listener_.isLeft(); }));
  EXPECT_EQ(listener_.forces().back(), 0.0);
  EXPECT_TRUE(waitUntil([&] { return hasEnded(left[0]); }));
}

TEST_F(PluginOfAProgram, EndsWhenTheProgramIsKilledWhileItHangs)
{
  startPushing("hang in write");
  program_->send(SIGKILL);
  EXPECT_TRUE(waitUntil([this] { return listener_.isLeft(); }));
}

TEST_F(PluginOfAProgram, WritesZeroButStaysWhileTheProgramIsStopped)
{
  startPushing();
  program_->send(SIGSTOP);
  EXPECT_TRUE(waitUntil([this] { return listener_.force() == 0.0; }));
  EXPECT_FALSE(listener_.isLeft());
  const auto received = listener_.forces().size();
  program_->send(SIGCONT);
  EXPECT_TRUE(waitUntil([&] { return listener_.forces().size() > received; }));
}

}  // namespace
}  // namespace perilymph::test
