// SPDX-License-Identifier: BSD-3-Clause
#include "ServiceSocket.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <utility>

namespace perilymph::haply {

namespace asio = boost::asio;
using boost::system::error_code;

std::string ServiceSocket::connect(const std::string& host, const std::string& port)
{
  link_ = std::make_unique<Link>();
  Link& link = *link_;
  std::optional<error_code> result;
  asio::ip::tcp::resolver resolver(link.io);
  error_code unresolved;
  const auto places = resolver.resolve(host, port, unresolved);
  if (unresolved) {
    link_.reset();
    return unresolved.message();
  }
  asio::async_connect(link.stream.next_layer(), places,
                      [&](const error_code& connecting, const asio::ip::tcp::endpoint&) {
                        result = connecting;
                        if (connecting) return;
                        result.reset();
                        link.stream.async_handshake(
                            host + ":" + port, "/",
                            [&](const error_code& shaking) { result = shaking; });
                      });
  link.io.run_for(std::chrono::seconds(1));
  std::string why =
      result ? (*result ? result->message() : std::string()) : "no answer in a second";
  if (why.empty()) {
    error_code ignored;  // only speed depends on it
    link.stream.next_layer().set_option(asio::ip::tcp::no_delay(true), ignored);
    link.stream.text(true);
  } else {
    link_.reset();
  }
  return why;
}

void ServiceSocket::startReading()
{
  Link& link = *link_;
  link.isReading = true;
  link.stream.async_read(link.incoming, [&link](const error_code& error, std::size_t) {
    link.isReading = false;
    link.hasMessage = !error;
    link.hasFailed = link.hasFailed || error;
  });
}

std::optional<std::string> ServiceSocket::receive(Duration timeout)
{
  if (!isConnected()) return std::nullopt;
  Link& link = *link_;
  if (!link.isReading && !link.hasMessage) startReading();
  const auto end = std::chrono::steady_clock::now() + timeout;
  link.io.restart();
  while (!link.hasMessage && !link.hasFailed && link.io.run_one_until(end) > 0) continue;
  if (!link.hasMessage) return std::nullopt;
  link.hasMessage = false;
  std::string message = boost::beast::buffers_to_string(link.incoming.data());
  link.incoming.consume(link.incoming.size());
  return message;
}

bool ServiceSocket::send(std::string message)
{
  if (!isConnected()) return false;
  Link& link = *link_;
  link.io.restart();
  link.io.poll();
  if (link.isWriting) return false;
  link.outgoing = std::move(message);
  link.isWriting = true;
  link.stream.async_write(asio::buffer(link.outgoing),
                          [&link](const error_code& error, std::size_t) {
                            link.isWriting = false;
                            link.hasFailed = link.hasFailed || error;
                          });
  link.io.restart();
  link.io.poll();  // so that it leaves now; the system's buffer takes it at once
  return true;
}

}  // namespace perilymph::haply
