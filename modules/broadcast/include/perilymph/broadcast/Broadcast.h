// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A server that sends a running insertion to programs that speak OpenIGTLink, such as 3D Slicer.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/broadcast/BroadcastFrame.h"
#include "perilymph/broadcast/CtImage.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::broadcast {

/// Where a server listens.
struct Endpoint {
  std::string address = "127.0.0.1";  ///< Numeric, IPv4 or IPv6; by default only this machine.
  std::uint16_t port = 18944;         ///< OpenIGTLink's; 0: any free port.
};

/// Reads "[ADDRESS:]PORT": "18944", "192.168.0.7:18944", "[::1]:18944". Names are refused: nothing
/// is looked up.
Result<Endpoint> parseEndpoint(const std::string& text);

/// Maximum triangles of a surface that is sent: a message of 1 MB.
inline constexpr int maxSurfaceTriangles = 20'000;

/// Counters since the start.
struct BroadcastFigures {
  std::uint64_t clients = 0;   ///< Connected now.
  std::uint64_t accepted = 0;  ///< Connections that were accepted.
  std::uint64_t closed = 0;    ///< Connections that were closed because of the client's fault.
  std::uint64_t frames = 0;    ///< Frames that were packed.
  std::uint64_t skipped = 0;   ///< Frames that a client was too slow for.
};

/// The walls of a cochlea, in W [m]. Empty ones are not sent.
struct Walls {
  anatomy::Surface tympani, vestibuli;
};
Walls wallsOf(const anatomy::ScalaTympani& scala);

/// Sends frames to at most eight clients, from a thread of its own, and the array's surface ten times
/// a second. The walls, the CT and the transform to the patient are sent on connection, when they
/// change, and on request. Only sends: requests (GET_ and the type) are answered, by a STATUS if there
/// is no such thing; everything else that a client sends is dropped. No client delays the publisher or
/// another client: each has one message at most on its way, and one that takes nothing for 5 s is
/// closed. A ninth client takes the place of the one that has sent no message for longest, if for 5 s
/// or more.
class Broadcast {
public:
  /// Receives one sentence for each client that is closed by its own fault, by the server's thread,
  /// at most 100 times; and from start(), one if others than this machine's programs can connect.
  using Report = std::function<void(const std::string&)>;

  /// Starts to listen. The error states why the endpoint cannot be used.
  static Result<std::unique_ptr<Broadcast>> start(const Endpoint& endpoint, Report report);
  ~Broadcast();  ///< Closes all connections.
  Broadcast(const Broadcast&) = delete;
  Broadcast& operator=(const Broadcast&) = delete;

  /// The port listened at.
  std::uint16_t port() const noexcept;

  /// Sends a frame to all clients, as soon as they take it. One thread, never the haptic one.
  void publish(const BroadcastFrame& frame) noexcept;
  /// The walls that are sent from now on, in RAS if a placement is given. The same thread. The array's
  /// surface is made from the newest frame.
  void show(const Walls& walls, const std::optional<Placement>& patient = std::nullopt);
  /// The transform from the frame that is sent to the patient's RAS; empty ends that. The same
  /// thread.
  void show(const std::optional<Placement>& toPatient);
  /// The CT that is sent; null ends that. The same thread. A client that receives it misses the
  /// frames of that time.
  void show(PackedImage image);
  /// Sends that nothing of an insertion is known, and then nothing until the next frame. The same
  /// thread.
  void clear();

  /// Any thread.
  BroadcastFigures figures() const noexcept;

private:
  struct Content;
  explicit Broadcast(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::broadcast
