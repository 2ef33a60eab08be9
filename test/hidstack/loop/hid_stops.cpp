// SPDX-License-Identifier: BSD-3-Clause

// Stops an insertion with the virtual handle in every way that the window has, by the window's own
// classes: hid_stops PROFILE LOG. The log has one row for each way: the time from which the force
// shall end, and the way's number.

#include <poll.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "FlatWallScene.h"
#include "StopCalls.h"
#include "TickLog.h"
#include "perilymph/realtime/Pacer.h"
#include "perilymph/session/Csv.h"
#include "virtualDevice.h"

namespace {

using namespace perilymph;
using namespace perilymph::hidstack;
using haptics::Workflow;

constexpr double patience = 5.0;  // [s]
constexpr int glance_ms = 20;     // as often as the window's display
constexpr int steadyGlances = 5;
/// Ratio of the force at the handle to that on the array: the handle runs into the wall with all its
/// force, and the array must not be jammed by it.
constexpr double strongScale = 20.0;

/// Lets the window live until something is true. False after `patience`.
bool waitUntil(gui::InsertionControl& control, const std::function<bool()>& claim)
{
  for (int waited_ms = 0; waited_ms < static_cast<int>(1e3 * patience); waited_ms += glance_ms) {
    control.update();
    if (claim()) return true;
    ::poll(nullptr, 0, glance_ms);
  }
  return false;
}

Result<void> pushSteadily(gui::InsertionControl& control)
{
  if (const auto prepared = control.prepare(gui::InputSource::device); !prepared) return prepared;
  if (const auto begun = control.begin(); !begun) return begun;
  int steady = 0;
  const bool isPushing = waitUntil(control, [&] {
    const auto& force_D = control.now().output.wrench_D.force_D;
    steady = force_D[2] > 0.95 * strongPush ? steady + 1 : 0;
    return steady >= steadyGlances;
  });
  if (isPushing) return {};
  return Error{"The handle was not pushed with " + std::to_string(strongPush) + " N."};
}

/// Stops once and notes when. The window's thread is blocked afterwards.
Result<void> stop(std::size_t way, gui::InsertionControl& control, std::vector<ReportRow>& log)
{
  gui::SafetyStop safety(control);
  if (const auto pushed = pushSteadily(control); !pushed) return pushed;
  const bool isLater = std::string(stopWays[way]) == "focus_away";
  const std::int64_t now = realtime::monotonicNanoseconds();
  stopCalls[way](control, safety);
  log.push_back({now + (isLater ? static_cast<std::int64_t>(1e9 * focusTime) : 0),
                 static_cast<std::int64_t>(way)});
  ::poll(nullptr, 0, isLater ? static_cast<int>(1e3 * focusTime) + 100 : 100);
  control.update();
  const bool isPaused = control.now().output.workflow == Workflow::paused;
  std::cout << "measure stops." << stopWays[way] << "_paused " << (isPaused ? 1 : 0) << '\n';
  // The device is closed before the handle is unplugged.
  if (const auto closed = control.prepare(gui::InputSource::scripted); !closed) return closed;
  if (waitUntil(control, [] { return device::findHidNodes().empty(); })) return {};
  return Error{"The handle was not unplugged."};
}

Result<void> stopInEveryWay(const std::string& profile, const std::string& log)
{
  auto scenario = session::loadScenario(
      "contour-published",
      {{"force_scale", session::shortestDecimal(strongScale)},
       {"coupling_stiffness_N_m", session::shortestDecimal(couplingStiffness / strongScale)},
       {"coupling_damping_N_s_m", session::shortestDecimal(1.0 / strongScale)}});
  if (!scenario) return scenario.error();
  auto anatomy = session::buildAnatomy(*scenario);
  if (!anatomy) return anatomy.error();
  gui::InsertionControl control(*scenario, std::nullopt);
  control.disableRecording();
  control.use(*scenario, gui::InsertionControl::Parts{*anatomy, flatWallModel()});
  control.choose([&profile]() -> Result<std::unique_ptr<device::HapticDevice>> {
    auto hand = openVirtualDevice(profile, patience);
    if (!hand) return hand.error();
    return std::unique_ptr<device::HapticDevice>(*std::move(hand));
  });
  std::vector<ReportRow> rows;
  for (std::size_t way = 0; way < stopWays.size(); ++way)
    if (const auto stopped = stop(way, control, rows); !stopped)
      return Error{std::string(stopWays[way]) + ": " + stopped.error().message};
  return write(log, rows);
}

}  // namespace

int main(int count, char** text)
{
  if (count != 3) {
    std::cerr << "hid_stops needs a device profile and a file for its log.\n";
    return 2;
  }
  const auto done = stopInEveryWay(text[1], text[2]);
  if (done) return EXIT_SUCCESS;
  std::cerr << done.error().message << '\n';
  return EXIT_FAILURE;
}
