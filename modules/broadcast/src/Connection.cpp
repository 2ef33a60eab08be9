// SPDX-License-Identifier: BSD-3-Clause
#include "Connection.h"

#include <sys/socket.h>
#include <unistd.h>

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
    : socket_(std::move(socket)), name_(std::move(name)), tookAt_(now), finishedAt_(now)
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

void Connection::send(const SharedBytes& surface, const SharedBytes& capability, std::int64_t now)
{
  while (!hasEnded_) {
    if (!isBusy() && wantsCapability_) {
      wantsCapability_ = false;
      offer(capability, now);
    }
    if (!isBusy() && wantsSurface_ && surface) {
      wantsSurface_ = false;
      offer(surface, now);
    }
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
      finishedAt_ = now;
      const std::string& type = reader_.request()->type;
      const std::string& device = reader_.request()->device;
      if (type == "GET_CAPABIL") wantsCapability_ = true;
      if (type == "GET_POLYDATA" && (device.empty() || device == surfaceName)) wantsSurface_ = true;
    }
    if (!reader_.fault().empty()) end(reader_.fault());
  }
}

void Connection::checkPatience(std::int64_t now)
{
  if (hasEnded_) return;
  if (isBusy() && now - tookAt_ > patience) end("it took nothing for 5 s");
  if (reader_.isWithinMessage() && now - finishedAt_ > patience)
    end("it left a message unfinished for 5 s");
}

}  // namespace perilymph::broadcast
