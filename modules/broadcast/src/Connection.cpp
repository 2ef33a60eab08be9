// SPDX-License-Identifier: BSD-3-Clause
#include "Connection.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <span>

namespace perilymph::broadcast {

namespace {

constexpr std::int64_t patience = 5'000'000'000;  // [ns]
// A client that sends without pause gets its turn again after the others.
constexpr int maxPieces = 16;

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

void Connection::answer(bool& isWanted, const SharedBytes& bytes, std::int64_t now)
{
  if (isWanted && bytes && offer(bytes, now)) isWanted = false;
}

void Connection::send(const Answers& answers, std::int64_t now)
{
  while (!hasEnded_) {
    answer(wantsCapability_, answers.capability, now);
    answer(wantsScala_, answers.scala, now);
    answer(wantsArray_, answers.array, now);
    answer(wantsImage_, answers.image, now);
    if (!isBusy()) return;
    // MSG_NOSIGNAL: a client that is gone is an error, not a signal.
    const ssize_t count = ::send(file(), sending_->data() + sent_, sending_->size() - sent_,
                                 MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && isOnlyLater()) return;
    if (count < 0) return end({});
    tookAt_ = now;
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
  if (request.type == "GET_CAPABIL") wantsCapability_ = true;
  const auto isFor = [&](const char* type, const char* name) {
    return request.type == type && (request.device.empty() || request.device == name);
  };
  if (isFor("GET_POLYDATA", scalaName)) wantsScala_ = true;
  if (isFor("GET_POLYDATA", arrayName)) wantsArray_ = true;
  if (isFor("GET_IMAGE", ctName)) wantsImage_ = true;
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
