// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A device of a laboratory that exists only here: a handle in a hand, in memory shared between the test
// and the substitute of the device's library, which is loaded into the process of the plug-in.

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <new>

namespace perilymph::test {

using Vector3 = std::array<double, 3>;

inline std::int64_t monotonic() noexcept
{
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// The time that a device takes [ns].
inline void elapse(std::int64_t time) noexcept
{
  const timespec rest{time / 1'000'000'000, time % 1'000'000'000};
  ::ppoll(nullptr, 0, &rest, nullptr);
}

/// Written by the test, or by the device; all in SI units and frame D.
struct PeerState {
  enum Fault : int {
    none,
    absent,     ///< Not plugged in when it is opened.
    silent,     ///< Plugged in, and answers nothing.
    unplugged,  ///< Pulled out while it is open.
  };

  // By the test.
  std::atomic<int> fault{none};
  std::atomic<unsigned> buttons{0};           ///< Bit 0: the one that grasps.
  std::array<std::atomic<double>, 3> hand{};  ///< Where the hand takes the handle to [m].
  std::atomic<int> isReady{1};      ///< Falcon: homed; Touch: calibrated; Inverse3: has a grip.
  std::atomic<int> hasFirmware{1};  ///< Falcon.
  std::atomic<double> driverLimit{100.0};    ///< Touch: nominal maximum force [N].
  std::atomic<double> turn{0.0};             ///< Rotation of the handle about z [rad].
  std::atomic<std::int64_t> answerDelay{0};  ///< Inverse3 [ns].

  // By the device.
  std::atomic<std::uint64_t> opened{0}, closed{0}, exchanges{0};
  std::array<std::atomic<double>, 3> force{};  ///< On the hand [N].
  std::atomic<std::uint64_t> firmwareBytes{0}, firmwareSum{0};
  std::atomic<std::uint64_t> unread{0};  ///< Falcon: bytes of answers that wait after a read.

  struct Entry {
    std::int64_t time;  ///< [ns]
    double magnitude;   ///< [N]
  };
  static constexpr std::size_t capacity = 100'000;
  std::array<Entry, capacity> log{};
  std::atomic<std::size_t> count{0};
};

/// The handle, in the one thread that acts for the device.
class PeerHandle {
public:
  explicit PeerHandle(PeerState& state) : state_(state), time_(monotonic()) {}

  /// The position now [m]: the hand takes it to its target at 20 mm/s, and gives way to the force like
  /// a spring of 5 N/mm.
  Vector3 position()
  {
    constexpr double speed = 0.02, stiffness = 5000.0;
    const std::int64_t time = monotonic();
    const double reach = speed * 1e-9 * static_cast<double>(time - time_);
    time_ = time;
    Vector3 way, place;
    for (std::size_t i = 0; i < 3; ++i) way[i] = state_.hand[i] - held_[i];
    const double distance = std::hypot(way[0], way[1], way[2]);
    const double part = distance > reach ? reach / distance : 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      held_[i] += part * way[i];
      place[i] = held_[i] + state_.force[i] / stiffness;
    }
    return place;
  }

  void render(const Vector3& force)
  {
    for (std::size_t i = 0; i < 3; ++i) state_.force[i] = force[i];
    const std::size_t at = state_.count;
    if (at < PeerState::capacity)
      state_.log[at] = {monotonic(), std::hypot(force[0], force[1], force[2])};
    if (at < PeerState::capacity) state_.count = at + 1;
    ++state_.exchanges;
  }

private:
  PeerState& state_;
  std::int64_t time_;
  Vector3 held_{};
};

inline constexpr const char* peerVariable = "PERILYMPH_TEST_PEER";

/// Maps the state that the environment names; null if there is none.
inline PeerState* sharedPeer()
{
  const char* path = std::getenv(peerVariable);
  const int file = path != nullptr ? ::open(path, O_RDWR | O_CLOEXEC) : -1;
  if (file < 0) return nullptr;
  void* const place =
      ::mmap(nullptr, sizeof(PeerState), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  return place != MAP_FAILED ? static_cast<PeerState*>(place) : nullptr;
}

}  // namespace perilymph::test
