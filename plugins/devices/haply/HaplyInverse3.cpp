// SPDX-License-Identifier: BSD-3-Clause

// The Haply Inverse3 with a VerseGrip as a device plug-in, by Haply's Inverse Service. Not tried on
// hardware: see the guide, laboratory-devices.md.

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "HaplyMessages.h"
#include "PluginEntry.h"
#include "ServiceSocket.h"
#include "ServoThread.h"

namespace perilymph::haply {

namespace {

using plugin::Answer;
using namespace std::chrono_literals;

// No published maximum was found (chosen; below the 3.3 N that an insertion renders at most).
constexpr double maxForce = 3.0;  // [N]
// In which Haply's own tutorials keep the cursor.
constexpr double workspaceRadius = 0.10;  // [m]
// Read half as often as it is exchanged: the program takes samples for old after three periods, and a
// service without real-time priority has gaps of 3 ms (chosen).
constexpr double period = 2e-3;          // [s]
constexpr double exchangePeriod = 1e-3;  // [s]
/// Assumed where the service does not answer when the plug-in is loaded (chosen) [s].
constexpr double assumedRoundTrip = 2e-3;
constexpr auto replyPatience = 20ms, openingPatience = 1000ms;

struct Place {
  std::string host = "localhost", port = "10001";
};

/// Where the service listens: PERILYMPH_HAPLY_SERVICE, as host:port.
Place servicePlace()
{
  Place place;
  const char* text = std::getenv("PERILYMPH_HAPLY_SERVICE");
  const std::string given = text != nullptr ? text : "";
  const auto colon = given.rfind(':');
  if (colon == std::string::npos) return place;
  return {given.substr(0, colon), given.substr(colon + 1)};
}

/// A session with the service and its first Inverse3.
class Session {
public:
  /// Returns an empty text, or a sentence for the user.
  std::string begin()
  {
    const Place place = servicePlace();
    const std::string where = place.host + ":" + place.port;
    const std::string why = socket_.connect(place.host, place.port);
    if (!why.empty())
      return "The Haply Inverse Service does not answer at " + where + ": " + why +
             ". Start it, or Haply Hub.";
    waiting_ = 0;
    const auto message = socket_.receive(openingPatience);
    const auto inventory = message ? inventoryOf(*message) : std::nullopt;
    if (!inventory)
      return "What listens at " + where +
             " does not list devices as the Haply Inverse Service 3.5 does. Update the service.";
    if (inventory->inverse3.empty())
      return "The Haply Inverse Service finds no Inverse3. Check its cable and power.";
    if (!inventory->hasGrip)
      return "The Haply Inverse Service finds no VerseGrip, whose button is needed to grasp. "
             "Connect or pair it.";
    id_ = inventory->inverse3;
    return {};
  }
  void end() noexcept { socket_.close(); }
  const std::string& id() const noexcept { return id_; }

  /// Sends a message unless an earlier one waits for its answer, but one for an urgent message. False
  /// if it was not sent.
  bool send(const std::string& message, bool isUrgent)
  {
    if (waiting_ > (isUrgent ? 1 : 0) || !socket_.send(message)) return false;
    ++waiting_;
    return true;
  }
  /// The answer to the newest message, which tells the newest state.
  std::optional<std::string> answer(std::chrono::milliseconds patience)
  {
    std::optional<std::string> newest;
    while (waiting_ > 0) {
      newest = socket_.receive(patience);
      if (!newest) return std::nullopt;
      --waiting_;
    }
    return newest;
  }
  bool isConnected() const noexcept { return socket_.isConnected(); }

private:
  ServiceSocket socket_;
  std::string id_;
  int waiting_ = 0;  // messages without an answer
};

/// Time from a message to the state that answers it: the median of some exchanges [s]. As assumed if
/// the service or the device is not there. Asks only, and neither claims nor moves the device, which
/// another program may have open.
double measuredRoundTrip()
{
  constexpr std::size_t exchanges = 51;
  Session session;
  if (!session.begin().empty()) return assumedRoundTrip;
  std::vector<std::int64_t> times;
  for (std::size_t i = 0; i < exchanges; ++i) {
    const std::int64_t began = plugin::now();
    if (!session.send(probeMessage(session.id()), false) || !session.answer(replyPatience))
      return assumedRoundTrip;
    times.push_back(plugin::now() - began);
  }
  std::nth_element(times.begin(), times.begin() + exchanges / 2, times.end());
  return 1e-9 * static_cast<double>(times[exchanges / 2]);
}

class HaplyInverse3 {
public:
  ~HaplyInverse3() { close(); }

  static void state(PerilymphDeviceTraitsV1& traits)
  {
    std::snprintf(traits.name, sizeof traits.name, "Haply Inverse3");
    traits.renders_force = 1;
    traits.max_force_N = maxForce;
    traits.nominal_period_s = period;
    traits.workspace_radius_m = workspaceRadius;
    // A force waits half an exchange for the next one.
    traits.transport_delay_s = 0.5 * exchangePeriod + measuredRoundTrip();
    traits.sensed_translations = 3;
    traits.sensed_rotations = 3;
    traits.actuated_translations = 3;
    traits.buttons = 3;
  }

  std::string open()
  {
    close();
    std::string error = session_.begin();
    if (error.empty() &&
        (!session_.send(openingMessage(session_.id()), false) || !session_.answer(openingPatience)))
      error = "The Haply Inverse Service does not answer a command. Restart it.";
    if (!error.empty()) {
      session_.end();
      return error;
    }
    servo_.start(link_, [this](const Vector& force, Sample& out) { return exchange(force, out); });
    return {};
  }

  void close() noexcept
  {
    servo_.stop();
    session_.end();
  }

  plugin::DeviceLink& link() { return link_; }

private:
  Answer exchange(const Vector& force_D, Sample& sample) noexcept
  {
    try {
      if (session_.send(forceMessage(session_.id(), force_D), force_D == Vector{}))
        link_.noteSent();
      const auto message = session_.answer(replyPatience);
      if (!session_.isConnected()) return Answer::lost;
      if (!message) return Answer::silent;
      const auto state = sampleOf(*message, session_.id());
      if (!state) return Answer::lost;
      sample = *state;
      return Answer::fresh;
    } catch (const std::exception&) {
      return Answer::lost;
    }
  }

  plugin::DeviceLink link_{maxForce};
  Session session_;
  plugin::ServoThread servo_;  // destroyed first
};

}  // namespace

}  // namespace perilymph::haply

PERILYMPH_DEVICE_PLUGIN(perilymph::haply::HaplyInverse3);
