// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/broadcast/Broadcast.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <deque>
#include <initializer_list>
#include <mutex>
#include <thread>
#include <vector>

#include "ArraySurface.h"
#include "Connection.h"
#include "perilymph/anatomy/ScalaVestibuli.h"
#include "perilymph/foundation/RealTime.h"
#include "perilymph/realtime/Pacer.h"
#include "perilymph/realtime/TripleBuffer.h"

namespace perilymph::broadcast {

namespace {

constexpr std::size_t maxClients = 8;
constexpr int maxReports = 100;
constexpr int look_ms = 500;  // between two looks at clients that do nothing
// Between two surfaces of the array, 40 KB each: five frames (choice).
constexpr std::int64_t arrayInterval = 100'000'000;  // [ns]
// A client whose machine is switched off sends no end: asked after 5 s, given up after 10 s.
constexpr int silentBeforeProbe_s = 5;
constexpr int maxUnacknowledged_ms = 10'000;

/// What the publisher sets, and every client receives.
constexpr std::array modelItems{Item::placement, Item::tympani, Item::vestibuli, Item::image};

/// A socket address, IPv4 or IPv6.
struct Address {
  sockaddr_storage storage{};
  socklen_t size = sizeof(sockaddr_storage);

  sockaddr* get() noexcept { return reinterpret_cast<sockaddr*>(&storage); }
  const sockaddr_in& four() const noexcept { return reinterpret_cast<const sockaddr_in&>(storage); }
  const sockaddr_in6& six() const noexcept
  {
    return reinterpret_cast<const sockaddr_in6&>(storage);
  }
  bool isFour() const noexcept { return storage.ss_family == AF_INET; }
  std::uint16_t port() const noexcept
  {
    return ntohs(isFour() ? four().sin_port : six().sin6_port);
  }
  std::string text() const
  {
    char name[INET6_ADDRSTRLEN] = "";
    const void* const place = isFour() ? static_cast<const void*>(&four().sin_addr)
                                       : static_cast<const void*>(&six().sin6_addr);
    ::inet_ntop(storage.ss_family, place, name, sizeof name);
    return (isFour() ? std::string(name) : "[" + std::string(name) + "]") + ":" +
           std::to_string(port());
  }
};

Address addressOf(const Endpoint& endpoint)
{
  Address address;
  auto& four = reinterpret_cast<sockaddr_in&>(address.storage);
  auto& six = reinterpret_cast<sockaddr_in6&>(address.storage);
  if (::inet_pton(AF_INET, endpoint.address.c_str(), &four.sin_addr) == 1) {
    four.sin_family = AF_INET;
    four.sin_port = htons(endpoint.port);
    address.size = sizeof four;
  } else if (::inet_pton(AF_INET6, endpoint.address.c_str(), &six.sin6_addr) == 1) {
    six.sin6_family = AF_INET6;
    six.sin6_port = htons(endpoint.port);
    address.size = sizeof six;
  }
  return address;
}

Error refused(const Endpoint& endpoint, int why)
{
  if (why == EADDRINUSE)
    return Error{
        "The port %1 at %2 is taken by another program. End that program, or choose another port.",
        endpoint.port, endpoint.address};
  if (why == EADDRNOTAVAIL)
    return Error{
        "%1 is not an address of this computer. 127.0.0.1 always is; 'ip address' lists all.",
        endpoint.address};
  return Error{"The port %1 at %2 cannot be listened at: %3.", endpoint.port, endpoint.address,
               std::strerror(why)};
}

/// True for an address at which only programs of this machine connect.
bool isLoopback(const Address& address) noexcept
{
  if (address.isFour()) return ntohl(address.four().sin_addr.s_addr) >> 24 == IN_LOOPBACKNET;
  return IN6_IS_ADDR_LOOPBACK(&address.six().sin6_addr);
}

/// A listening socket.
Result<OwnedSocket> listenAt(const Endpoint& endpoint)
{
  Address address = addressOf(endpoint);
  if (address.storage.ss_family == AF_UNSPEC) return refused(endpoint, EADDRNOTAVAIL);
  OwnedSocket listener(
      ::socket(address.storage.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (listener.get() < 0) return refused(endpoint, errno);
  // Connections that ended a minute ago do not keep the port; a program that listens does.
  const int yes = 1;
  ::setsockopt(listener.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (::bind(listener.get(), address.get(), address.size) != 0) return refused(endpoint, errno);
  if (::listen(listener.get(), static_cast<int>(maxClients)) != 0) return refused(endpoint, errno);
  return listener;
}

void prepareClient(int file)
{
  const int yes = 1;
  // Small messages at once, instead of waiting for more.
  ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  ::setsockopt(file, SOL_SOCKET, SO_KEEPALIVE, &yes, sizeof yes);
  ::setsockopt(file, IPPROTO_TCP, TCP_KEEPIDLE, &silentBeforeProbe_s, sizeof silentBeforeProbe_s);
  ::setsockopt(file, IPPROTO_TCP, TCP_USER_TIMEOUT, &maxUnacknowledged_ms,
               sizeof maxUnacknowledged_ms);
}

}  // namespace

struct Broadcast::Content {
  Content(OwnedSocket listening, OwnedSocket bell, Report reporting)
      : listener(std::move(listening)), wake(std::move(bell)), report(std::move(reporting))
  {
  }

  void serve();
  void welcome(std::int64_t now);
  void sendFrame(std::int64_t now);
  void takeModel();
  void packAnswers(const Connection& client);
  SharedBytes packedArray() const;
  void dismiss();
  void tell(const std::string& sentence);
  void setModel(std::initializer_list<std::pair<Item, SharedBytes>> changes);
  void ring() noexcept
  {
    const std::uint64_t one = 1;
    // A full counter is a bell that rings already.
    if (::write(wake.get(), &one, sizeof one) < 0) return;
  }

  OwnedSocket listener, wake;
  Report report;
  std::uint16_t port = 0;
  std::atomic<bool> isStopping{false};
  realtime::TripleBuffer<BroadcastFrame> frames;
  std::mutex modelMutex;  // between the publisher's thread and the server's; no other
  Answers model;          // placement, walls and image; the others are the server's
  std::atomic<std::uint64_t> clients{0}, accepted{0}, closed{0}, framesPacked{0}, skipped{0};
  std::thread thread;

  // Owned by the server's thread.
  std::deque<Connection> connections;
  Answers answers;
  bool hasFrame = false;
  std::int64_t arrayAt = 0;  // when the array was sent [ns]
  int reports = 0;
};

void Broadcast::Content::serve()
{
  answers[Item::capability] = std::make_shared<const Bytes>(capabilityMessage());
  std::vector<pollfd> waits;
  while (!isStopping) {
    waits = {{wake.get(), POLLIN, 0}, {listener.get(), POLLIN, 0}};
    for (const Connection& client : connections)
      waits.push_back(
          {client.file(), static_cast<short>(client.isBusy() ? POLLIN | POLLOUT : POLLIN), 0});
    ::poll(waits.data(), waits.size(), look_ms);
    const std::int64_t now = realtime::monotonicNanoseconds();
    takeModel();
    std::uint64_t rings = 0;
    if (waits[0].revents != 0 && ::read(wake.get(), &rings, sizeof rings) > 0) sendFrame(now);

    answers[Item::frame].reset();
    answers[Item::array].reset();
    for (std::size_t i = 0; i < connections.size(); ++i) {
      Connection& client = connections[i];
      const auto [file, events, revents] = waits[i + 2];
      if (revents != 0) client.receive(now);
      packAnswers(client);
      client.send(answers, now);
      client.checkPatience(now);
    }
    dismiss();
    if (waits[1].revents != 0) welcome(now);
    clients = connections.size();
  }
}

/// Called by the publisher's thread.
void Broadcast::Content::setModel(std::initializer_list<std::pair<Item, SharedBytes>> changes)
{
  {
    const std::lock_guard lock(modelMutex);
    for (const auto& [item, bytes] : changes) model[item] = bytes;
  }
  ring();
}

/// What has changed is sent to all clients.
void Broadcast::Content::takeModel()
{
  const std::lock_guard lock(modelMutex);
  for (const Item item : modelItems) {
    const bool isNew = model[item] && model[item] != answers[item];
    answers[item] = model[item];
    if (!isNew) continue;
    for (Connection& client : connections) client.want(item);
  }
}

void Broadcast::Content::sendFrame(std::int64_t now)
{
  if (!frames.refresh()) return;
  hasFrame = frames.latest().isShown;
  if (connections.empty()) return;
  Bytes bytes = frameMessages(frames.latest());
  if (now - arrayAt >= arrayInterval)
    if (const SharedBytes array = packedArray()) {
      bytes.insert(bytes.end(), array->begin(), array->end());
      arrayAt = now;
    }
  const auto shared = std::make_shared<const Bytes>(std::move(bytes));
  ++framesPacked;
  for (Connection& client : connections)
    if (!client.offer(shared, now)) ++skipped;
}

/// Once for all clients that asked for it since the last look.
void Broadcast::Content::packAnswers(const Connection& client)
{
  if (!hasFrame) return;
  if (client.wants(Item::array) && !answers[Item::array]) answers[Item::array] = packedArray();
  if (client.wants(Item::frame) && !answers[Item::frame])
    answers[Item::frame] = std::make_shared<const Bytes>(frameMessages(frames.latest()));
}

/// The surface of the newest frame's array; null if it has none.
SharedBytes Broadcast::Content::packedArray() const
{
  const BroadcastFrame& frame = frames.latest();
  const anatomy::Surface array = arraySurface(frame);
  if (array.triangles.empty()) return nullptr;
  return std::make_shared<const Bytes>(surfaceMessage(array, arrayName, frame.patient));
}

void Broadcast::Content::welcome(std::int64_t now)
{
  Address peer;
  OwnedSocket socket(
      ::accept4(listener.get(), peer.get(), &peer.size, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (socket.get() < 0) return;
  if (connections.size() >= maxClients && !makeRoom(connections, now)) {
    ++closed;
    tell("The OpenIGTLink client " + peer.text() + " was refused: " + std::to_string(maxClients) +
         " are connected. Disconnect one.");
    return;
  }
  dismiss();
  prepareClient(socket.get());
  connections.emplace_back(std::move(socket), peer.text(), now);
  for (const Item item : modelItems) connections.back().want(item);
  connections.back().send(answers, now);
  ++accepted;
}

/// Removes the clients that have ended.
void Broadcast::Content::dismiss()
{
  for (auto client = connections.begin(); client != connections.end();) {
    if (!client->hasEnded()) {
      ++client;
      continue;
    }
    if (!client->fault().empty()) {
      ++closed;
      tell(client->fault());
    }
    client = connections.erase(client);
  }
}

void Broadcast::Content::tell(const std::string& sentence)
{
  if (++reports <= maxReports && report) report(sentence);
}

Walls wallsOf(const anatomy::ScalaTympani& scala)
{
  return {anatomy::wallSurface(scala, maxSurfaceTriangles),
          anatomy::vestibuliSurface(scala, maxSurfaceTriangles)};
}

Broadcast::Broadcast(std::unique_ptr<Content> content) : content_(std::move(content))
{
  content_->thread = std::thread([this] {
    declareThread(ThreadRole::broadcast);
    content_->serve();
  });
}

Broadcast::~Broadcast()
{
  content_->isStopping = true;
  content_->ring();
  content_->thread.join();
}

Result<std::unique_ptr<Broadcast>> Broadcast::start(const Endpoint& endpoint, Report report)
{
  auto listener = listenAt(endpoint);
  if (!listener) return listener.error();
  Address bound;
  ::getsockname(listener->get(), bound.get(), &bound.size);
  OwnedSocket wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (wake.get() < 0) return refused(endpoint, errno);
  if (report && !isLoopback(bound))
    report("Whoever reaches " + bound.text() +
           " in the network receives the insertion and the CT, without a password. 127.0.0.1 "
           "serves this machine only.");
  auto content =
      std::make_unique<Content>(*std::move(listener), std::move(wake), std::move(report));
  content->port = bound.port();
  return std::unique_ptr<Broadcast>(new Broadcast(std::move(content)));
}

std::uint16_t Broadcast::port() const noexcept { return content_->port; }

void Broadcast::publish(const BroadcastFrame& frame) noexcept
{
  content_->frames.publish(frame);
  content_->ring();
}

void Broadcast::show(const Walls& walls, const std::optional<Placement>& patient)
{
  const auto packed = [&](const anatomy::Surface& surface, const char* name) -> SharedBytes {
    if (surface.triangles.empty()) return nullptr;
    return std::make_shared<const Bytes>(surfaceMessage(surface, name, patient));
  };
  content_->setModel({{Item::tympani, packed(walls.tympani, scalaName)},
                      {Item::vestibuli, packed(walls.vestibuli, vestibuliName)}});
}

void Broadcast::show(const std::optional<Placement>& toPatient)
{
  content_->setModel(
      {{Item::placement,
        toPatient ? std::make_shared<const Bytes>(placementMessage(*toPatient)) : nullptr}});
}

void Broadcast::show(PackedImage image) { content_->setModel({{Item::image, std::move(image)}}); }

void Broadcast::clear()
{
  content_->setModel({{Item::placement, nullptr},
                      {Item::tympani, nullptr},
                      {Item::vestibuli, nullptr},
                      {Item::image, nullptr}});
  BroadcastFrame nothing;
  nothing.isShown = false;
  publish(nothing);
}

BroadcastFigures Broadcast::figures() const noexcept
{
  const Content& content = *content_;
  return {content.clients, content.accepted, content.closed, content.framesPacked, content.skipped};
}

}  // namespace perilymph::broadcast
