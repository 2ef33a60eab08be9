// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One client of a broadcast: what waits to be sent to it, and what it asks for.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "Messages.h"
#include "RequestReader.h"

namespace perilymph::broadcast {

/// A file descriptor with ownership.
class OwnedSocket {
public:
  explicit OwnedSocket(int file = -1) noexcept : file_(file) {}
  OwnedSocket(OwnedSocket&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  OwnedSocket& operator=(OwnedSocket&& other) noexcept
  {
    std::swap(file_, other.file_);
    return *this;
  }
  ~OwnedSocket();
  int get() const noexcept { return file_; }

private:
  int file_;
};

/// Messages that several connections send, packed once.
using SharedBytes = std::shared_ptr<const Bytes>;

/// The answers to requests; null while there is none.
struct Answers {
  SharedBytes scala, array, image, capability;
};

/// A connected client. Never blocks; memory is bounded by one message at a time.
class Connection {
public:
  /// @param socket  Connected, non-blocking. @param now  On the monotonic clock [ns].
  Connection(OwnedSocket socket, std::string name, std::int64_t now);

  int file() const noexcept { return socket_.get(); }
  /// Something waits to be sent.
  bool isBusy() const noexcept { return sending_ != nullptr; }

  /// Begins to send a frame. False if the client has not yet taken what was sent before.
  bool offer(const SharedBytes& frame, std::int64_t now);
  /// It asked for the array, which is made for the answer.
  bool wantsArray() const noexcept { return wantsArray_; }
  /// Sends what the client takes, then what it asked for.
  void send(const Answers& answers, std::int64_t now);
  /// Reads what the client sent.
  void receive(std::int64_t now);
  /// Ends a client that takes nothing, or leaves a message unfinished, for 5 s. A megabyte of a long
  /// message is as good as its end.
  void checkPatience(std::int64_t now);
  /// How long it has sent no message [ns].
  std::int64_t silence(std::int64_t now) const noexcept { return now - saidAt_; }
  /// Ends a client that is silent, so that another one has its place.
  void giveWay(std::int64_t now);

  bool hasEnded() const noexcept { return hasEnded_; }
  /// A sentence: the client's fault; empty if it only went.
  const std::string& fault() const noexcept { return fault_; }

private:
  void end(const std::string& why);
  void answer(bool& isWanted, const SharedBytes& bytes, std::int64_t now);
  void note(const RequestReader::Request& request);

  OwnedSocket socket_;
  std::string name_;
  RequestReader reader_;
  SharedBytes sending_;
  std::size_t sent_ = 0;
  bool wantsScala_ = false, wantsArray_ = false, wantsImage_ = false, wantsCapability_ = false;
  std::int64_t tookAt_, finishedAt_;  // the client: bytes of ours, a message of its own [ns]
  std::int64_t saidAt_;               // its last message [ns]; at first, when it connected
  std::uint64_t skippedThen_ = 0;     // bytes skipped at finishedAt_
  bool hasEnded_ = false;
  std::string fault_;
};

/// Ends the client that has been silent longest, if that is 5 s or more. False if none is.
bool makeRoom(std::deque<Connection>& clients, std::int64_t now);

}  // namespace perilymph::broadcast
