// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One client of a broadcast: what waits to be sent to it, and what it asks for.

#include <array>
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

/// What a client is sent on request, in the order in which it is sent. Those from `placement` to
/// `image` are also sent on connection and when they change.
enum class Item { capability, frame, placement, tympani, vestibuli, array, image };
inline constexpr std::size_t items = 7;

/// The messages of all items; null while there is none.
struct Answers {
  std::array<SharedBytes, items> bytes;

  SharedBytes& operator[](Item item) { return bytes[static_cast<std::size_t>(item)]; }
  const SharedBytes& operator[](Item item) const { return bytes[static_cast<std::size_t>(item)]; }
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
  /// Sends an item as soon as there is one and the client takes it.
  void want(Item item) noexcept { wanted_[static_cast<std::size_t>(item)] = true; }
  /// An item is to be sent; those that are made for the answer are made then.
  bool wants(Item item) const noexcept { return wanted_[static_cast<std::size_t>(item)]; }
  /// Sends what the client takes, then what it asked for; a megabyte at a time, so that the other
  /// clients do not wait for one that takes much. An item that it asked for by name and that does
  /// not exist yet is announced by a STATUS, and sent later.
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
  void beginNext(const Answers& answers, std::int64_t now);
  void note(const RequestReader::Request& request);
  void addStatus(const std::string& device, std::uint16_t code, const std::string& sentence);

  OwnedSocket socket_;
  std::string name_;
  RequestReader reader_;
  SharedBytes sending_;
  std::size_t sent_ = 0;
  std::array<bool, items> wanted_{};
  std::array<std::string, items> asked_;  // the device, until its absence was stated
  std::deque<SharedBytes> statuses_;      // at most maxStatuses
  std::int64_t tookAt_, finishedAt_;      // the client: bytes of ours, a message of its own [ns]
  std::int64_t saidAt_;                   // its last message [ns]; at first, when it connected
  std::uint64_t skippedThen_ = 0;         // bytes skipped at finishedAt_
  bool hasEnded_ = false;
  std::string fault_;
};

/// Ends the client that has been silent longest, if that is 5 s or more. False if none is.
bool makeRoom(std::deque<Connection>& clients, std::int64_t now);

}  // namespace perilymph::broadcast
