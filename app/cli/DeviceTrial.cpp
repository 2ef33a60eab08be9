// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceTrial.h"

#include <algorithm>
#include <cmath>

#include "Interruption.h"
#include "Terminal.h"
#include "perilymph/device/PluginDevice.h"
#include "perilymph/haptics/CouplingLimit.h"
#include "perilymph/haptics/ForceTrial.h"
#include "perilymph/realtime/Pacer.h"
#include "perilymph/realtime/RealTimePriority.h"

namespace perilymph::cli {

namespace {

constexpr double timeStep = 1e-3;       // [s]
constexpr double shippedDamping = 1.0;  // of the coupling in the shipped scenarios [N.s/m]
constexpr double listeningTime = 3.0;   // [s]
// Far below what a hand feels (20 mN; Kratchman et al. 2016).
constexpr double minForce = 1e-3;  // [N]

/// Ticks at 1 kHz, triggered by the device's reports if possible.
class TickClock {
public:
  explicit TickClock(device::HapticDevice& device)
      : device_(device),
        pacer_(Duration::fromSi(timeStep)),
        follows_(haptics::followsReports(device.traits(), timeStep))
  {
    pacer_.start(realtime::monotonicNanoseconds());
  }

  void wait()
  {
    const auto awaited =
        follows_ ? device_.await(Duration::fromSi(timeStep)) : device::Awaited::cannot;
    if (awaited == device::Awaited::cannot)
      pacer_.wait();
    else
      pacer_.follow(realtime::monotonicNanoseconds());
  }

private:
  device::HapticDevice& device_;
  realtime::Pacer pacer_;
  bool follows_;
};

int ticks(double time) { return static_cast<int>(std::lround(time / timeStep)); }

void noteButton(const device::DeviceSample& sample, TrialOutcome& outcome)
{
  outcome.wasPressed |= sample.isValid != 0 && (sample.buttons & device::graspButton) != 0;
}

void listen(device::HapticDevice& device, TickClock& clock, TrialOutcome& outcome)
{
  print("Listening for {} s. Move the device.\n", fixed(listeningTime, 0));
  flushOutput();
  std::uint64_t last = 0;
  for (int i = 0; i < ticks(listeningTime) && !isInterrupted(); ++i) {
    clock.wait();
    const device::DeviceSample sample = device.read();
    ++outcome.samples;
    if (sample.isValid != 0 && sample.sequence != last) ++outcome.fresh;
    noteButton(sample, outcome);
    last = sample.sequence;
    device.write({});
  }
}

/// Why the trial ended before its last axis.
std::string whyUntested(device::HapticDevice& device, const TrialOutcome& outcome, int axis)
{
  const auto health = device.health();
  if (health && !health->isConnected) return "the device was disconnected";
  if (health ? health->reading.fresh == 0 : outcome.fresh == 0) return "no report came";
  constexpr double stalled = 0.1;  // [s]
  if (health && health->reading.silence > stalled) return "the reports ended";
  const bool wasPushed = outcome.forces.at(static_cast<std::size_t>(axis)).peak > 0.0;
  return wasPushed ? "no push was finished: the button was let go, or reports were missing"
                   : "the button was not held";
}

void showForces(device::HapticDevice& device, TickClock& clock, TrialOutcome& outcome)
{
  haptics::ForceTrial trial(device.traits(), timeStep);
  outcome.greatest = trial.greatest();
  outcome.greatestTorque = trial.greatestTorque();
  if (trial.isOver()) return;
  print(
      "Hold the device and its button: it pushes with at most {} N along each axis{}. Letting "
      "go of the button ends the push.\n",
      fixed(trial.greatest(), 2),
      device.traits().maxTorque > 0.0
          ? ", then turns with at most " + fixed(trial.greatestTorque() * 1e3, 0) +
                " mN.m about each"
          : "");
  flushOutput();
  while (!trial.isOver() && !isInterrupted()) {
    clock.wait();
    const device::DeviceSample sample = device.read();
    noteButton(sample, outcome);
    device.write(trial.step(sample));
  }
  device.write({});
  outcome.forces = trial.results();
  if (!trial.isDone()) outcome.untested = whyUntested(device, outcome, trial.axis());
}

int actuatedAxes(const device::DeviceTraits& traits)
{
  int count = 0;
  for (int i = 0; i < 3; ++i)
    count += (traits.pushesAlong(i) ? 1 : 0) + (traits.turnsAbout(i) ? 1 : 0);
  return count;
}

Result<TrialOutcome> tryOpened(device::HapticDevice& device)
{
  if (const auto opened = device.open(); !opened) return opened.error();
  watchForInterruption();
  // Without the priority the figures are worse, but valid.
  realtime::requestRealTimePriority();

  TrialOutcome outcome;
  outcome.traits = device.traits();
  outcome.axes = actuatedAxes(outcome.traits);
  outcome.canBePressed = outcome.traits.buttons > 0;
  if (outcome.axes > 0) {
    outcome.stiffness = haptics::couplingLimit(outcome.traits, timeStep).stiffness;
    outcome.passiveHandleDamping = haptics::passiveHandleDamping(
        outcome.stiffness, shippedDamping, haptics::delayOf(outcome.traits, timeStep), timeStep);
  }
  TickClock clock(device);
  listen(device, clock, outcome);
  if (outcome.axes > 0) showForces(device, clock, outcome);
  outcome.health = device.health();
  device.close();
  if (isInterrupted()) return Error{"Interrupted; the force is off."};
  return outcome;
}

}  // namespace

int TrialOutcome::axesShown() const
{
  return static_cast<int>(std::count_if(forces.begin(), forces.end(), [](const auto& axis) {
    return axis.isDone && axis.peak > minForce;  // a torque of 1 mN.m is as clear
  }));
}

std::string TrialOutcome::shortcoming() const
{
  const auto reports =
      health && !isPlugin ? health->reading.fresh : static_cast<std::uint64_t>(fresh);
  if (reports == 0) return "no report came";
  if (axesShown() < axes)
    return "the force was rendered on " + std::to_string(axesShown()) + " of " +
           std::to_string(axes) + " axes" + (untested.empty() ? "" : ": " + untested);
  for (std::size_t i = 0; i < forces.size(); ++i)
    if (forces[i].isAgainst)
      return std::string("the handle ") + (i < 3 ? "moved along " : "turned about ") +
             std::string(1, "xyz"[i % 3]) + " against the " + (i < 3 ? "force" : "torque") +
             ": its sign is wrong, or the hand pushed. Hold it loosely and test again";
  if (canBePressed && !wasPressed) return "the button was not pressed";
  return {};
}

Result<TrialOutcome> tryDevice(const device::FoundDevice& found, const std::filesystem::path& tape)
{
  auto made = device::makeHidDevice(found, device::systemRoots(), tape);
  if (!made) return made.error();
  return tryOpened(**made);
}

Result<TrialOutcome> tryPlugin(const std::filesystem::path& library)
{
  auto loaded = device::loadPluginDevice(library);
  if (!loaded) return loaded.error();
  auto trial = tryOpened(**loaded);
  if (trial) trial->isPlugin = true;
  return trial;
}

}  // namespace perilymph::cli
