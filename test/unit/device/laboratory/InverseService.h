// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A substitute of Haply's Inverse Service with an Inverse3 and a VerseGrip behind it: a WebSocket server
// that tells its devices to a new client and answers each message with their state.

#include <atomic>
#include <thread>

#include "PeerState.h"

namespace perilymph::test {

class InverseService {
public:
  /// @param state  Must outlive this object.
  explicit InverseService(PeerState& state);
  ~InverseService();
  InverseService(const InverseService&) = delete;
  InverseService& operator=(const InverseService&) = delete;

  int port() const { return port_; }
  /// Ends the service as if it crashed: its connection breaks.
  void end();

private:
  void serve(int listener);

  PeerState& state_;
  int port_ = 0;
  std::atomic<bool> isStopping_{false};
  std::thread thread_;
};

}  // namespace perilymph::test
