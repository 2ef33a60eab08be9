// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The device at the other end of the socket of SocketDevice.c: it renders the last force that it
// received, and none without a connection, as a device whose driver was closed.

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "SocketPort.h"

namespace perilymph::test {

class ListeningDevice {
public:
  explicit ListeningDevice(const std::string& name) : listener_(listenAs(name))
  {
    if (listener_ >= 0) thread_ = std::thread([this] { serve(); });
  }
  ~ListeningDevice()
  {
    isStopping_ = true;
    if (thread_.joinable()) thread_.join();
    ::close(listener_);
  }
  ListeningDevice(const ListeningDevice&) = delete;
  ListeningDevice& operator=(const ListeningDevice&) = delete;

  bool isThere() const { return listener_ >= 0; }
  /// All forces received so far, in order [N].
  std::vector<double> forces() const
  {
    const std::lock_guard lock(mutex_);
    return forces_;
  }
  /// All torques received so far, in order [N.m].
  std::vector<double> torques() const
  {
    const std::lock_guard lock(mutex_);
    return torques_;
  }
  bool hasReceived(double force) const
  {
    for (const double received : forces())
      if (received == force) return true;
    return false;
  }
  /// A connection was there and has ended.
  bool isLeft() const { return isLeft_; }
  /// The force on the hand now [N].
  double force() const
  {
    const auto received = forces();
    return isLeft_ || received.empty() ? 0.0 : received.back();
  }

private:
  void serve()
  {
    int file = -1;
    while (!isStopping_) {
      pollfd waits{file < 0 ? listener_ : file, POLLIN, 0};
      if (::poll(&waits, 1, 1) <= 0) continue;
      if (file < 0) {
        file = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        isLeft_ = false;
        continue;
      }
      double wrench[2] = {0.0, 0.0};
      if (::recv(file, wrench, sizeof wrench, 0) == sizeof wrench) {
        const std::lock_guard lock(mutex_);
        forces_.push_back(wrench[0]);
        torques_.push_back(wrench[1]);
        continue;
      }
      ::close(file);
      file = -1;
      isLeft_ = true;
    }
    if (file >= 0) ::close(file);
  }

  int listener_;
  mutable std::mutex mutex_;
  std::vector<double> forces_, torques_;
  std::atomic<bool> isLeft_{false}, isStopping_{false};
  std::thread thread_;
};

}  // namespace perilymph::test
