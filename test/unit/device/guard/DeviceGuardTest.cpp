// SPDX-License-Identifier: BSD-3-Clause

// What a device receives when the program that renders force with it ends, for every kind of end.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <mutex>
#include <thread>
#include <vector>

#include "SocketPort.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Not;
using Bytes = std::vector<std::uint8_t>;

// As in the profile: report 2 has three numbers; report 9 switches the device off.
const Bytes noForce = {2, 0, 0, 0, 0, 0, 0};
const Bytes push = {2, 0, 0, 0, 0, 0xf4, 0x01};  // 500 counts of 1 mN along z
const Bytes left = {9, 77};

/// The device: sends a report every millisecond on every reporting connection, and stores what it
/// receives.
class SocketDevice {
public:
  explicit SocketDevice(const std::string& name) : listener_(listenAs(name))
  {
    if (listener_ >= 0) thread_ = std::thread([this] { serve(); });
  }
  ~SocketDevice()
  {
    isStopping_ = true;
    if (thread_.joinable()) thread_.join();
    for (const int file : reporting_) ::close(file);
    if (guard_ >= 0) ::close(guard_);
    ::close(listener_);
  }
  SocketDevice(const SocketDevice&) = delete;
  SocketDevice& operator=(const SocketDevice&) = delete;

  bool isThere() const { return listener_ >= 0; }
  std::vector<Bytes> fromProgram() const
  {
    const std::lock_guard lock(mutex_);
    return fromProgram_;
  }
  std::vector<Bytes> fromGuard() const
  {
    const std::lock_guard lock(mutex_);
    return fromGuard_;
  }
  bool hasGuardLeft() const { return hasGuardLeft_; }

private:
  void serve()
  {
    while (!isStopping_) {
      std::vector<pollfd> waits{{listener_, POLLIN, 0}, {guard_, POLLIN, 0}};
      for (const int file : reporting_) waits.push_back({file, POLLIN, 0});
      ::poll(waits.data(), waits.size(), 1);
      if ((waits[0].revents & POLLIN) != 0) welcome();
      if (guard_ >= 0 && waits[1].revents != 0) hearGuard();
      for (std::size_t i = 2; i < waits.size(); ++i)
        if ((waits[i].revents & POLLIN) != 0) hearProgram(waits[i].fd);
      report();
    }
  }
  void welcome()
  {
    const int file = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    char letter = 0;
    if (file < 0 || ::recv(file, &letter, 1, 0) != 1) return;
    if (letter == 'g')
      guard_ = file;
    else
      reporting_.push_back(file);
  }
  void hearGuard()
  {
    std::array<std::uint8_t, 64> buffer{};
    const ssize_t count = ::recv(guard_, buffer.data(), buffer.size(), 0);
    if (count <= 0) {
      ::close(guard_);
      guard_ = -1;
      hasGuardLeft_ = true;
      return;
    }
    const std::lock_guard lock(mutex_);
    fromGuard_.emplace_back(buffer.begin(), buffer.begin() + count);
  }
  void hearProgram(int file)
  {
    std::array<std::uint8_t, 64> buffer{};
    const ssize_t count = ::recv(file, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count <= 0) return;
    const std::lock_guard lock(mutex_);
    fromProgram_.emplace_back(buffer.begin(), buffer.begin() + count);
  }
  void report()
  {
    ++counter_;
    const std::array<std::uint8_t, 9> bytes{1, static_cast<std::uint8_t>(counter_ & 0xff),
                                            static_cast<std::uint8_t>(counter_ >> 8 & 0xff)};
    for (const int file : reporting_)
      ::send(file, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  }

  int listener_;
  int guard_ = -1;
  unsigned counter_ = 0;
  std::vector<int> reporting_;
  mutable std::mutex mutex_;
  std::vector<Bytes> fromProgram_, fromGuard_;
  std::atomic<bool> hasGuardLeft_{false}, isStopping_{false};
  std::thread thread_;
};

class DeviceOfAProgram : public testing::Test {
protected:
  void SetUp() override { ASSERT_TRUE(device_.isThere()) << "No socket to be had."; }

  /// Runs until the program renders a force.
  void startPushing(const std::string& fault = "none")
  {
    program_ = std::make_unique<ChildProcess>(
        ProgramCall{testProgram("guarded_hand"), {name_, fault}, {}, std::nullopt});
    ASSERT_TRUE(program_->waitForOutput("guarded\n", seconds(30)));
    ASSERT_TRUE(program_->waitForOutput("pushing\n", seconds(30)));
  }
  void waitUntilGuardLeft() const
  {
    EXPECT_TRUE(waitUntil([this] { return device_.hasGuardLeft(); }));
  }

  /// A busy machine may also stop the program for a moment; then there was no force before.
  void expectSwitchedOff() const
  {
    EXPECT_THAT(device_.fromProgram(), Contains(push));
    std::vector<Bytes> heard = device_.fromGuard();
    ASSERT_GE(heard.size(), 3u);
    const std::vector<Bytes> last(heard.end() - 3, heard.end());
    EXPECT_THAT(last, ElementsAre(noForce, noForce, left));
    heard.resize(heard.size() - 3);
    EXPECT_THAT(heard, Each(noForce));
  }

  const std::string name_ = "perilymph-guard-test-" + std::to_string(::getpid());
  SocketDevice device_{name_};
  std::unique_ptr<ChildProcess> program_;
};

TEST_F(DeviceOfAProgram, IsToldNoForceAndSwitchedOffWhenItIsKilled)
{
  startPushing();
  program_->send(SIGKILL);
  waitUntilGuardLeft();
  expectSwitchedOff();
}

TEST_F(DeviceOfAProgram, IsSwitchedOffWhenTheWholeGroupOfProcessesIsKilled)
{
  startPushing();
  ::kill(-::getpgid(program_->id()), SIGKILL);
  waitUntilGuardLeft();
  expectSwitchedOff();
}

TEST_F(DeviceOfAProgram, IsSwitchedOffWhenItReadsMemoryThatIsNotThere)
{
  startPushing("segv");
  // A sanitizer handles the signal, prints a stack trace, and ends the program with its own status.
  const auto end = program_->wait(seconds(60));
  EXPECT_TRUE(end.signal != 0 || end.status != 0);
  waitUntilGuardLeft();
  expectSwitchedOff();
}

TEST_F(DeviceOfAProgram, IsSwitchedOffWhenItAborts)
{
  startPushing("abort");
  EXPECT_NE(program_->wait(seconds(60)).signal, 0);
  waitUntilGuardLeft();
  expectSwitchedOff();
}

TEST_F(DeviceOfAProgram, IsNotSwitchedOffTwiceWhenItIsClosedInOrder)
{
  startPushing();
  program_->send(SIGTERM);
  EXPECT_EQ(program_->wait(seconds(60)).status, 0);
  waitUntilGuardLeft();
  EXPECT_EQ(device_.fromProgram().back(), left);
  EXPECT_THAT(device_.fromGuard(), Not(Contains(left)));
}

TEST_F(DeviceOfAProgram, LosesItsForceButIsNotSwitchedOffWhileItIsStopped)
{
  startPushing();
  program_->send(SIGSTOP);
  ASSERT_TRUE(waitUntil([this] { return !device_.fromGuard().empty(); }));
  EXPECT_FALSE(device_.hasGuardLeft());
  EXPECT_THAT(device_.fromGuard(), Each(noForce));
  program_->send(SIGCONT);
  program_->send(SIGTERM);
  EXPECT_EQ(program_->wait(seconds(60)).status, 0);
}

}  // namespace
}  // namespace perilymph::test
