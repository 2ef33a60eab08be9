// SPDX-License-Identifier: BSD-3-Clause
#include "Connection.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <span>
#include <string_view>

namespace perilymph::broadcast {

namespace {

constexpr std::int64_t patience = 5'000'000'000;  // [ns]
// A client that sends or takes without pause gets its turn again after the others.
constexpr int maxPieces = 16;
constexpr std::size_t maxSentAtOnce = 1 << 20;
// Answers to requests for what does not exist; further ones are dropped until these are taken.
constexpr std::size_t maxStatuses = 16;
// As the protocol numbers them.
constexpr std::uint16_t statusOk = 1, statusNotFound = 4, statusUnknownInstruction = 12,
                        statusNotReady = 13;

/// A device that can be requested.
struct Device {
  const char* type;  ///< "GET_" in front of it requests one, in at most 12 characters.
  const char* name;
  Item item;
};
constexpr std::array devices{Device{"TRANS", tipName, Item::frame},
                             Device{"TRANS", tweezersName, Item::frame},
                             Device{"TRANS", forceVectorName, Item::frame},
                             Device{"TRANS", toPatientName, Item::placement},
                             Device{"POINT", contactsName, Item::frame},
                             Device{"SENSOR", forceName, Item::frame},
                             Device{"STRING", readoutName, Item::frame},
                             Device{"POLYDATA", scalaName, Item::tympani},
                             Device{"POLYDATA", vestibuliName, Item::vestibuli},
                             Device{"POLYDATA", arrayName, Item::array},
                             Device{"IMAGE", ctName, Item::image}};

bool isOnlyLater() noexcept { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

OwnedSocket::~OwnedSocket()
{
  if (file_ >= 0) ::close(file_);
}

Connection::Connection(OwnedSocket socket, std::string name, std::int64_t now)
    : socket_(std::move(socket)),
      name_(std::move(name)),
      tookAt_(now),
      finishedAt_(now),
      saidAt_(now)
{
}

void Connection::end(const std::string& why)
{
  hasEnded_ = true;
  if (!why.empty()) fault_ = "The OpenIGTLink client " + name_ + " was disconnected: " + why + ".";
}

bool Connection::offer(const SharedBytes& frame, std::int64_t now)
{
  if (isBusy() || hasEnded_) return false;
  sending_ = frame;
  sent_ = 0;
  tookAt_ = now;
  return true;
}

void Connection::beginNext(const Answers& answers, std::int64_t now)
{
  for (std::size_t i = 0; i < items; ++i) {
    if (!wanted_[i] || answers.bytes[i] || asked_[i].empty()) continue;
    addStatus(asked_[i], statusNotReady,
              "There is no " + asked_[i] + " yet. It is sent as soon as there is one.");
    asked_[i].clear();
  }
  if (!isBusy() && !statuses_.empty()) {
    offer(statuses_.front(), now);
    statuses_.pop_front();
  }
  for (std::size_t i = 0; i < items && !isBusy(); ++i) {
    if (!wanted_[i] || !answers.bytes[i]) continue;
    offer(answers.bytes[i], now);
    wanted_[i] = false;
    asked_[i].clear();
  }
}

void Connection::send(const Answers& answers, std::int64_t now)
{
  std::size_t total = 0;
  while (!hasEnded_) {
    beginNext(answers, now);
    if (!isBusy() || total >= maxSentAtOnce) return;
    // MSG_NOSIGNAL: a client that is gone is an error, not a signal.
    const ssize_t count = ::send(file(), sending_->data() + sent_,
                                 std::min(sending_->size() - sent_, maxSentAtOnce - total),
                                 MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && isOnlyLater()) return;
    if (count < 0) return end({});
    tookAt_ = now;
    total += static_cast<std::size_t>(count);
    sent_ += static_cast<std::size_t>(count);
    if (sent_ == sending_->size()) sending_.reset();
  }
}

void Connection::receive(std::int64_t now)
{
  std::array<std::uint8_t, 4096> buffer;
  for (int i = 0; i < maxPieces && !hasEnded_; ++i) {
    const ssize_t count = ::recv(file(), buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count < 0 && isOnlyLater()) return;
    if (count <= 0) return end({});
    std::span<const std::uint8_t> rest(buffer.data(), static_cast<std::size_t>(count));
    if (!reader_.isWithinMessage()) finishedAt_ = now;
    while (!rest.empty() && reader_.fault().empty()) {
      rest = rest.subspan(reader_.take(rest));
      if (!reader_.request()) continue;
      finishedAt_ = saidAt_ = now;
      note(*reader_.request());
    }
    if (reader_.skipped() - skippedThen_ >= RequestReader::maxBody) {
      skippedThen_ = reader_.skipped();
      finishedAt_ = saidAt_ = now;
    }
    if (!reader_.fault().empty()) end(reader_.fault());
  }
}

void Connection::note(const RequestReader::Request& request)
{
  constexpr std::string_view prefix = "GET_";
  if (!request.type.starts_with(prefix)) return;
  const std::string type = request.type.substr(prefix.size());
  if (type == "CAPABIL") return want(Item::capability);
  if (type == "STATUS") return addStatus(request.device, statusOk, "Perilymph sends an insertion.");
  bool isType = false, isFound = false;
  for (const Device& device : devices) {
    if (type != device.type) continue;
    isType = true;
    if (!request.device.empty() && request.device != device.name) continue;
    want(device.item);
    // Of a request without a name, which is for all of a type, the first one answers for them.
    if (!request.device.empty() || !isFound)
      asked_[static_cast<std::size_t>(device.item)] = device.name;
    isFound = true;
  }
  if (!isType)
    addStatus(request.device, statusUnknownInstruction,
              "Perilymph sends no " + type + ". GET_CAPABIL requests the types that it sends.");
  else if (!isFound)
    addStatus(request.device, statusNotFound,
              "Perilymph sends no " + type + " of this name. A request without a name is for all.");
}

void Connection::addStatus(const std::string& device, std::uint16_t code,
                           const std::string& sentence)
{
  if (statuses_.size() >= maxStatuses) return;
  statuses_.push_back(std::make_shared<const Bytes>(statusMessage(device, code, sentence)));
}

void Connection::checkPatience(std::int64_t now)
{
  if (hasEnded_) return;
  if (isBusy() && now - tookAt_ > patience) end("it took nothing for 5 s");
  if (reader_.isWithinMessage() && now - finishedAt_ > patience)
    end("it left a message unfinished for 5 s");
}

void Connection::giveWay(std::int64_t now)
{
  end("all places are taken, and it asked for nothing for " +
      std::to_string(silence(now) / 1'000'000'000) + " s");
}

bool makeRoom(std::deque<Connection>& clients, std::int64_t now)
{
  const auto found = std::max_element(
      clients.begin(), clients.end(),
      [now](const Connection& a, const Connection& b) { return a.silence(now) < b.silence(now); });
  if (found == clients.end() || found->silence(now) < patience) return false;
  found->giveWay(now);
  return true;
}

}  // namespace perilymph::broadcast
