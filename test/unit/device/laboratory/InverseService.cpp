// SPDX-License-Identifier: BSD-3-Clause
#include "InverseService.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <chrono>
#include <nlohmann/json.hpp>

namespace perilymph::test {

namespace {

namespace asio = boost::asio;
using Json = nlohmann::json;
using boost::system::error_code;
using namespace std::chrono_literals;

constexpr const char* deviceId = "049D";

Json vec3(double x, double y, double z) { return {{"x", x}, {"y", y}, {"z", z}}; }

/// What the service knows of its client.
struct Client {
  PeerHandle handle;
  bool isCentered = false;  // the preset with the origin in the center of the workspace
};

/// The state of all devices, as an answer; with their configuration in the first message.
Json stateOf(const PeerState& state, Client& client, bool isFirst)
{
  Json message = {{"session_id", 7}, {"inverse3", Json::array()}};
  if (state.fault != PeerState::absent && state.fault != PeerState::unplugged) {
    const Vector3 at = client.handle.position();
    // x right, y forward, z up; without the preset from the base.
    const Vector3 center = client.isCentered ? Vector3{} : Vector3{0.0, -0.12, 0.15};
    Json device = {
        {"device_id", deviceId},
        {"state",
         {{"cursor_position", vec3(at[0] + center[0], -at[2] + center[1], at[1] + center[2])}}},
        {"status", {{"ready", true}}}};
    if (isFirst) device["config"] = {{"type", "inverse3"}, {"handedness", "right"}};
    message["inverse3"].push_back(device);
  }
  message["wireless_verse_grip"] = Json::array();
  if (state.isReady != 0) {
    const unsigned pressed = state.buttons;
    const double half = 0.5 * state.turn;  // about z of D, the service's backward y
    message["wireless_verse_grip"].push_back(
        {{"device_id", "61548"},
         {"state",
          {{"buttons",
            {{"a", (pressed & 1) != 0}, {"b", (pressed & 2) != 0}, {"c", (pressed & 4) != 0}}},
           {"orientation",
            {{"w", std::cos(half)}, {"x", 0.0}, {"y", -std::sin(half)}, {"z", 0.0}}}}}});
  }
  return message;
}

/// Obeys a message.
void obey(const std::string& text, PeerState& state, Client& client)
{
  const Json message = Json::parse(text);
  for (const Json& device : message.value("inverse3", Json::array())) {
    if (device.value("device_id", "") != deviceId) continue;
    const Json configured = device.value("configure", Json::object());
    if (configured.value(Json::json_pointer("/preset/preset"), "") == "arm_front_centered")
      client.isCentered = true;
    const Json commands = device.value("commands", Json::object());
    if (!commands.contains("set_cursor_force")) continue;
    const Json& force = commands["set_cursor_force"]["vector"];
    const bool isThere = state.fault != PeerState::unplugged;
    client.handle.render(isThere ? Vector3{force["x"], force["z"], -force["y"].get<double>()}
                                 : Vector3{});
  }
}

}  // namespace

InverseService::InverseService(PeerState& state) : state_(state)
{
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof place;
  if (::bind(listener, reinterpret_cast<sockaddr*>(&place), size) != 0 ||
      ::listen(listener, 4) != 0 ||
      ::getsockname(listener, reinterpret_cast<sockaddr*>(&place), &size) != 0)
    return;
  port_ = ntohs(place.sin_port);
  thread_ = std::thread([this, listener] { serve(listener); });
}

InverseService::~InverseService() { end(); }

void InverseService::end()
{
  isStopping_ = true;
  if (thread_.joinable()) thread_.join();
}

void InverseService::serve(int listener)
{
  asio::io_context io;
  asio::ip::tcp::acceptor acceptor(io, asio::ip::tcp::v4(), listener);
  while (!isStopping_) {
    boost::beast::websocket::stream<asio::ip::tcp::socket> stream(io);
    bool isConnected = false;
    acceptor.async_accept(stream.next_layer(),
                          [&](const error_code& error) { isConnected = !error; });
    while (!isConnected && !isStopping_) {
      io.restart();
      io.run_for(5ms);
    }
    if (isStopping_) {
      acceptor.close();
      io.restart();
      io.run_for(5ms);
      return;
    }
    error_code failed;
    stream.accept(failed);
    if (failed) continue;
    stream.next_layer().set_option(asio::ip::tcp::no_delay(true), failed);
    stream.text(true);
    ++state_.opened;
    Client client{PeerHandle(state_)};
    stream.write(asio::buffer(stateOf(state_, client, true).dump()), failed);
    boost::beast::flat_buffer incoming;
    bool isReading = false, hasMessage = false;
    int unanswered = 0;
    while (!failed && !isStopping_) {
      if (!isReading) {
        isReading = true;
        stream.async_read(incoming, [&](const error_code& error, std::size_t) {
          isReading = false;
          hasMessage = !error;
          if (error) failed = error;
        });
      }
      io.restart();
      io.run_one_for(5ms);
      if (hasMessage) {
        hasMessage = false;
        obey(boost::beast::buffers_to_string(incoming.data()), state_, client);
        incoming.consume(incoming.size());
        ++unanswered;
      }
      if (state_.fault == PeerState::silent) continue;
      for (; unanswered > 0 && !failed; --unanswered) {
        if (state_.answerDelay > 0) elapse(state_.answerDelay);
        stream.write(asio::buffer(stateOf(state_, client, false).dump()), failed);
      }
    }
    error_code ignored;
    stream.next_layer().close(ignored);
    io.restart();
    io.run_for(5ms);
    // Commands are forgotten: the device returns to idle.
    client.handle.render({});
    ++state_.closed;
  }
}

}  // namespace perilymph::test
