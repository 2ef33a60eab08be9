// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A WebSocket to a service on this machine, each of whose messages is answered by one.

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace perilymph::haply {

class ServiceSocket {
public:
  using Duration = std::chrono::milliseconds;

  /// Connects within a second. Returns an empty text, or why not.
  std::string connect(const std::string& host, const std::string& port);
  void close() noexcept { link_.reset(); }
  /// False once the service has closed the connection, or it broke.
  bool isConnected() const noexcept { return link_ && !link_->hasFailed; }

  /// The next message of the service; none if there is none in time or the connection is lost.
  std::optional<std::string> receive(Duration timeout);
  /// Starts to send a message. False if the one before is not sent yet.
  bool send(std::string message);

private:
  struct Link {
    boost::asio::io_context io;
    boost::beast::websocket::stream<boost::asio::ip::tcp::socket> stream{io};
    boost::beast::flat_buffer incoming;
    std::string outgoing;
    bool isReading = false, isWriting = false, hasMessage = false, hasFailed = false;
  };
  void startReading();

  std::unique_ptr<Link> link_;
};

}  // namespace perilymph::haply
