// SPDX-License-Identifier: BSD-3-Clause
#include "SocketPort.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace perilymph::test {

namespace {

using device::RawReport;
using device::Transfer;

class SocketTransport final : public device::Transport {
public:
  explicit SocketTransport(int file) : file_(file) {}
  ~SocketTransport() override { ::close(file_); }
  SocketTransport(const SocketTransport&) = delete;
  SocketTransport& operator=(const SocketTransport&) = delete;

  Transfer read(RawReport& report, Duration timeout) noexcept override
  {
    pollfd waits{file_, POLLIN, 0};
    if (::poll(&waits, 1, static_cast<int>(timeout.si() * 1e3)) <= 0) return Transfer::nothing;
    const ssize_t count = ::recv(file_, report.bytes.data(), report.bytes.size(), 0);
    if (count <= 0) return Transfer::gone;
    report.size = static_cast<std::size_t>(count);
    return Transfer::done;
  }
  Transfer write(const RawReport& report) noexcept override
  {
    const ssize_t count = ::send(file_, report.bytes.data(), report.size, MSG_NOSIGNAL);
    return count < 0 ? Transfer::gone : Transfer::done;
  }
  Transfer setFeature(const RawReport&) noexcept override { return Transfer::failed; }
  Transfer getFeature(RawReport&) noexcept override { return Transfer::failed; }

private:
  int file_;
};

class SocketPort final : public device::HidPort {
public:
  explicit SocketPort(std::string name) : name_(std::move(name)) {}

  Result<std::unique_ptr<device::Transport>> open() override
  {
    const int file = connectTo(name_, 'r');
    if (file < 0) return Error{"Nobody listens at the socket " + name_ + "."};
    return std::unique_ptr<device::Transport>(std::make_unique<SocketTransport>(file));
  }
  int fileForGuard() noexcept override { return connectTo(name_, 'g'); }
  void awaitChange(Duration) noexcept override {}

private:
  std::string name_;
};

struct Address {
  explicit Address(const std::string& name) noexcept
  {
    place.sun_family = AF_UNIX;
    // An abstract name begins with a zero: no file is left behind.
    const std::size_t length = std::min(name.size(), sizeof place.sun_path - 1);
    std::copy_n(name.begin(), length, place.sun_path + 1);
    size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
  }
  const sockaddr* get() const noexcept { return reinterpret_cast<const sockaddr*>(&place); }

  sockaddr_un place{};
  socklen_t size = 0;
};

}  // namespace

std::unique_ptr<device::HidPort> socketPort(std::string name)
{
  return std::make_unique<SocketPort>(std::move(name));
}

int connectTo(const std::string& name, char letter) noexcept
{
  const Address address(name);
  const int file = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  const bool isConnected = file >= 0 && ::connect(file, address.get(), address.size) == 0 &&
                           ::send(file, &letter, 1, MSG_NOSIGNAL) == 1;
  if (isConnected || file < 0) return file;
  ::close(file);
  return -1;
}

int listenAs(const std::string& name) noexcept
{
  const Address address(name);
  const int file = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  if (file < 0) return -1;
  if (::bind(file, address.get(), address.size) == 0 && ::listen(file, 8) == 0) return file;
  ::close(file);
  return -1;
}

}  // namespace perilymph::test
