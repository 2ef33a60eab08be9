// SPDX-License-Identifier: BSD-3-Clause
#include "LiveBroadcast.h"

#include <chrono>
#include <thread>

#include "Terminal.h"
#include "perilymph/realtime/Pacer.h"

namespace perilymph::cli {

namespace {

constexpr double interval = 0.02;  // 50 Hz, as trackers send [s]

}  // namespace

LiveBroadcast::LiveBroadcast(std::unique_ptr<broadcast::Broadcast> server,
                             session::Insertion& insertion)
    : server_(std::move(server)), insertion_(insertion), began_(realtime::monotonicNanoseconds())
{
}

Result<std::unique_ptr<LiveBroadcast>> LiveBroadcast::start(const std::string& endpoint,
                                                            session::Insertion& insertion)
{
  const auto place = broadcast::parseEndpoint(endpoint);
  if (!place) return place.error();
  auto server = broadcast::Broadcast::start(
      *place, [](const std::string& sentence) { printError("{}\n", sentence); });
  if (!server) return server.error();
  (*server)->show(broadcast::wallsOf(insertion.anatomy()));
  print("Sending to OpenIGTLink clients at {} port {}, in real time.\n", place->address,
        (*server)->port());
  flushOutput();
  return std::unique_ptr<LiveBroadcast>(new LiveBroadcast(*std::move(server), insertion));
}

void LiveBroadcast::show(const haptics::TickRecord& record)
{
  const double time = record.output.time;
  if (time < next_) return;
  next_ = time + interval;
  const auto passed = std::chrono::nanoseconds(realtime::monotonicNanoseconds() - began_);
  std::this_thread::sleep_for(std::chrono::duration<double>(time) - passed);
  if (insertion_.refresh())
    server_->publish(broadcast::broadcastFrame(insertion_.latest(), insertion_.parameters().array));
}

}  // namespace perilymph::cli
