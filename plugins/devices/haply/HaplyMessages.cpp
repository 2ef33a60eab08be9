// SPDX-License-Identifier: BSD-3-Clause
#include "HaplyMessages.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace perilymph::haply {

namespace {

using Json = nlohmann::json;

Json parsed(const std::string& message) { return Json::parse(message, nullptr, false); }

/// The devices of a kind; an empty list if there is none.
Json listOf(const Json& message, const char* kind)
{
  const auto found = message.is_object() ? message.find(kind) : message.end();
  return found != message.end() && found->is_array() ? *found : Json::array();
}

/// A member of an object, or nothing.
const Json* member(const Json& object, const char* name)
{
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found != object.end() ? &*found : nullptr;
}

std::optional<double> number(const Json& object, const char* name)
{
  const Json* value = member(object, name);
  if (value == nullptr || !value->is_number()) return std::nullopt;
  return value->get<double>();
}

bool isTrue(const Json* value)
{
  return value != nullptr && value->is_boolean() && value->get<bool>();
}

// The service's axes: x right, y forward, z up; D: x right, y up, z toward the user.
Vector toD(double x, double y, double z) { return {x, z, -y}; }
Json fromD(const Vector& v) { return {{"x", v[0]}, {"y", -v[2]}, {"z", v[1]}}; }

/// Whether a device is the one with the identifier.
bool hasId(const Json& device, const std::string& id)
{
  const Json* own = member(device, "device_id");
  return own != nullptr && own->is_string() && own->get<std::string>() == id;
}

/// Buttons and rotation of the grip, if the message contains one.
void addGrip(const Json& message, Sample& sample)
{
  sample.buttons = 0;
  for (const char* kind : {"wireless_verse_grip", "verse_grip"}) {
    const Json grips = listOf(message, kind);
    const Json* state = grips.empty() ? nullptr : member(grips.front(), "state");
    if (state == nullptr) continue;
    const Json* buttons = member(*state, "buttons");
    if (buttons != nullptr) {
      sample.buttons |= isTrue(member(*buttons, "a")) ? 1u : 0u;
      sample.buttons |= isTrue(member(*buttons, "b")) ? 2u : 0u;
      sample.buttons |= isTrue(member(*buttons, "c")) ? 4u : 0u;
    }
    sample.buttons |= isTrue(member(*state, "button")) ? 1u : 0u;
    const Json* turn = member(*state, "orientation");
    if (turn == nullptr) return;
    const auto w = number(*turn, "w"), x = number(*turn, "x"), y = number(*turn, "y"),
               z = number(*turn, "z");
    if (!w || !x || !y || !z) return;
    const double size = std::sqrt(*w * *w + *x * *x + *y * *y + *z * *z);
    if (!(size > 0.5)) return;  // not a rotation, with or without rounding
    const Vector axis = toD(*x / size, *y / size, *z / size);
    sample.rotation = {*w / size, axis[0], axis[1], axis[2]};
    return;
  }
}

Json command(const std::string& inverse3, const char* name, const Json& values)
{
  return {{"inverse3", {{{"device_id", inverse3}, {"commands", {{name, values}}}}}}};
}

}  // namespace

std::optional<Inventory> inventoryOf(const std::string& message)
{
  const Json json = parsed(message);
  if (!json.is_object()) return std::nullopt;
  Inventory inventory;
  const Json devices = listOf(json, "inverse3");
  const Json* id = devices.empty() ? nullptr : member(devices.front(), "device_id");
  if (id != nullptr && id->is_string()) inventory.inverse3 = id->get<std::string>();
  inventory.hasGrip =
      !listOf(json, "wireless_verse_grip").empty() || !listOf(json, "verse_grip").empty();
  return inventory;
}

std::string forceMessage(const std::string& inverse3, const Vector& force_D)
{
  return command(inverse3, "set_cursor_force", {{"vector", fromD(force_D)}}).dump();
}

std::string openingMessage(const std::string& inverse3)
{
  Json message = command(inverse3, "set_cursor_force", {{"vector", fromD({})}});
  message["session"]["configure"]["profile"]["name"] = "org.perilymph:insertion";
  message["inverse3"][0]["configure"]["preset"]["preset"] = "arm_front_centered";
  return message.dump();
}

std::string probeMessage(const std::string& inverse3)
{
  return command(inverse3, "probe_position", Json::object()).dump();
}

std::optional<Sample> sampleOf(const std::string& message, const std::string& inverse3)
{
  const Json json = parsed(message);
  for (const Json& device : listOf(json, "inverse3")) {
    if (!hasId(device, inverse3)) continue;
    const Json* state = member(device, "state");
    const Json* place = state != nullptr ? member(*state, "cursor_position") : nullptr;
    if (place == nullptr) return std::nullopt;
    const auto x = number(*place, "x"), y = number(*place, "y"), z = number(*place, "z");
    if (!x || !y || !z) return std::nullopt;
    Sample sample;
    sample.position = toD(*x, *y, *z);
    addGrip(json, sample);
    return sample;
  }
  return std::nullopt;
}

}  // namespace perilymph::haply
