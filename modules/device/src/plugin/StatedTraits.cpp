// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/StatedTraits.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <string>

namespace perilymph::device::plugin {

namespace {

std::string shortestText(double value)
{
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

}  // namespace

std::string sentenceOf(const Reply& reply)
{
  return std::string(reply.sentence.data(),
                     ::strnlen(reply.sentence.data(), reply.sentence.size()));
}

Result<DeviceTraits> checkedTraits(const PerilymphDeviceTraitsV1& said)
{
  DeviceTraits traits;
  traits.name = std::string(said.name, ::strnlen(said.name, sizeof said.name));
  if (traits.name.empty()) return Error{"its device has no name."};
  if (std::any_of(traits.name.begin(), traits.name.end(), [](char letter) {
        return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
      }))
    return Error{"the name of its device has a line break or another control character."};
  const auto within = [](double value, double minimum, double maximum) {
    return value >= minimum && value <= maximum;  // false for NaN
  };
  if (!within(said.nominal_period_s, 1e-4, 0.1))
    return Error{"its period between samples is %1 s; it must be between 0.0001 and 0.1.",
                 std::to_string(said.nominal_period_s)};
  if (said.renders_force != 0 && !within(said.max_force_N, 0.01, 50.0))
    return Error{"its greatest force is %1 N; it must be between 0.01 and 50.",
                 std::to_string(said.max_force_N)};
  // Choices, far beyond any device for a hand; with a longer delay no stiffness is left to render.
  struct Limit {
    Sentence name;
    double value, maximum;
    const char* unit;
  };
  for (const Limit& limit :
       {Limit{Sentence{"workspace radius"}, said.workspace_radius_m, 10.0, "m"},
        Limit{Sentence{"stiffness"}, said.max_stiffness_N_m, 1e6, "N/m"},
        Limit{Sentence{"damping"}, said.max_damping_N_s_m, 1e6, "N.s/m"},
        Limit{Sentence{"position quantum"}, said.position_quantum_m, 0.01, "m"},
        Limit{Sentence{"force quantum"}, said.force_quantum_N, 10.0, "N"},
        Limit{Sentence{"transport delay"}, said.transport_delay_s, 0.1, "s"},
        Limit{Sentence{"watchdog"}, said.watchdog_s, 10.0, "s"}})
    if (!within(limit.value, 0.0, limit.maximum))
      return Error{"its %1 is %2 %3; it must be between 0 and %4.", limit.name,
                   shortestText(limit.value), std::string(limit.unit), shortestText(limit.maximum)};
  for (const std::int32_t axes : {said.sensed_translations, said.sensed_rotations,
                                  said.actuated_translations, said.actuated_rotations})
    if (axes < 0 || axes > 3) return Error{"it counts %1 axes; there are 0 to 3 of a sort.", axes};
  if (said.buttons < 0 || said.buttons > 32)
    return Error{"it counts %1 buttons; 0 to 32 are known.", said.buttons};
  if ((said.renders_force != 0 || said.max_torque_N_m != 0.0) && said.buttons == 0)
    return Error{
        "it renders force and has no button: a force is only rendered while a button is held, and "
        "goes to zero when it is let go. State at least 1."};

  if (said.max_torque_N_m != 0.0 && !within(said.max_torque_N_m, 1e-4, 10.0))
    return Error{
        "its greatest torque is %1 N.m; it must be 0 (no torque) or between 0.0001 and 10.",
        std::to_string(said.max_torque_N_m)};
  if (said.actuated_axes != 0 &&
      (said.actuated_axes >= 64 ||
       std::popcount(said.actuated_axes & 7u) != said.actuated_translations ||
       std::popcount(said.actuated_axes >> 3) != said.actuated_rotations))
    return Error{
        "its axes %1 do not match its counts: %2 axes that it pushes along and %3 that it turns "
        "about.",
        said.actuated_axes, said.actuated_translations, said.actuated_rotations};

  traits.rendersForce = said.renders_force != 0;
  traits.maxForce = traits.rendersForce ? said.max_force_N : 0.0;
  traits.nominalPeriod = said.nominal_period_s;
  traits.workspaceRadius = said.workspace_radius_m;
  traits.maxStiffness = said.max_stiffness_N_m;
  traits.maxDamping = said.max_damping_N_s_m;
  traits.positionQuantum = said.position_quantum_m;
  traits.forceQuantum = said.force_quantum_N;
  traits.transportDelay = said.transport_delay_s;
  traits.watchdog = said.watchdog_s;
  traits.sensedTranslations = said.sensed_translations;
  traits.sensedRotations = said.sensed_rotations;
  traits.actuatedTranslations = said.actuated_translations;
  traits.actuatedRotations = said.actuated_rotations;
  traits.actuatedAxes = said.actuated_axes;
  traits.maxTorque = said.max_torque_N_m;
  traits.buttons = said.buttons;
  return traits;
}

}  // namespace perilymph::device::plugin
