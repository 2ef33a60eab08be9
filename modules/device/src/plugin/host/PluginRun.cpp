// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/host/PluginRun.h"

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Units.h"
#include "perilymph/realtime/Pacer.h"

namespace perilymph::device::plugin {

namespace {

// As for the guard of a HID device: longer than any delay of a program that runs.
constexpr double patience = 50e-3;  // [s]
// Limits of the traits (PluginDevice): here against a period of nothing.
constexpr double minPeriod = 1e-4, maxPeriod = 0.1;  // [s]

bool isFinite(const PerilymphDeviceSampleV1& sample) noexcept
{
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::all_of(std::begin(sample.position_D_m), std::end(sample.position_D_m), finite) &&
         std::all_of(std::begin(sample.rotation_D), std::end(sample.rotation_D), finite);
}

/// Writes a vector along the axes of the device (bits 0 to 2), shortened to the limit; zero if it is
/// not finite. True if the result is not zero.
bool putLimited(const std::array<double, 3>& vector, double limit, std::uint32_t axes,
                double* limited) noexcept
{
  double squared = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    if ((axes >> i & 1u) != 0) squared += vector[i] * vector[i];
  // Not for values that are not numbers, or overflow; a limit that is no number is none.
  if (!std::isfinite(squared) || !(limit > 0.0)) return false;
  const double scale = squared > limit * limit ? limit / std::sqrt(squared) : 1.0;
  for (std::size_t i = 0; i < 3; ++i)
    if ((axes >> i & 1u) != 0) limited[i] = scale * vector[i];
  return squared > 0.0;
}

double periodOf(const Library& library) noexcept
{
  const double period = library.traits().nominal_period_s;
  return period >= minPeriod ? std::min(period, maxPeriod) : minPeriod;
}

}  // namespace

PluginRun::PluginRun(Channel& channel, const Library& library, const std::atomic<bool>& isAlone,
                     const std::atomic<bool>& isDoomed) noexcept
    : channel_(channel),
      library_(library),
      isAlone_(isAlone),
      isDoomed_(isDoomed),
      period_(std::llround(periodOf(library) * 1e9)),
      patience_(static_cast<std::uint64_t>(
          std::ceil(std::max(patience, 3.0 * periodOf(library)) / periodOf(library))))
{
}

void PluginRun::run() noexcept
{
  // Forces of an earlier exchange are not for this one.
  Force old;
  channel_.forces.take(old, seen_);
  write({});
  read();  // before a force is answered: a sample that is not valid would be a lost device
  realtime::Pacer pacer(Duration::fromSi(static_cast<double>(period_) * 1e-9));
  pacer.start(realtime::monotonicNanoseconds());
  while (channel_.isClosing == 0 && !isAlone_) {
    channel_.forHost.waitUntil(pacer.due());
    takeForce();
    const std::int64_t now = realtime::monotonicNanoseconds();
    if (now < pacer.due()) continue;
    pacer.begin(now);
    if (++readsWithout_ >= patience_ && isPushing_) write({});
    read();
    channel_.samples.publish(newest_);
    channel_.forProgram.ring();
  }
  write({});
}

void PluginRun::takeForce() noexcept
{
  Force force;
  if (!channel_.forces.take(force, seen_)) return;
  readsWithout_ = 0;
  write(force);
  if (force.isMeasured == 0) return;
  channel_.samples.publish(newest_);
  channel_.forProgram.ring();
}

void PluginRun::write(const Force& force) noexcept
{
  if (isDoomed_) return;
  const PerilymphDeviceTraitsV1& traits = library_.traits();
  PerilymphDeviceWrenchV1 wrench{};
  wrench.size = sizeof wrench;
  constexpr std::uint32_t all = 0b111'111;
  const std::uint32_t axes = traits.actuated_axes != 0 ? traits.actuated_axes : all;
  const double maxForce = traits.renders_force != 0 ? traits.max_force_N : 0.0;
  const bool isForce = putLimited(force.force_D, maxForce, axes, wrench.force_D_N);
  const bool isTorque =
      putLimited(force.torque_D, traits.max_torque_N_m, axes >> 3, wrench.torque_D_N_m);
  isPushing_ = isForce || isTorque;

  const CallGuard mark(channel_, Function::write);
  newest_.isRefusing = library_.functions().write(library_.device(), &wrench) != 0 ? 1 : 0;
  if (newest_.isRefusing == 0 && force.number != 0) newest_.written = force.number;
}

void PluginRun::read() noexcept
{
  if (isDoomed_) return;
  PerilymphDeviceSampleV1 stated{};
  stated.size = sizeof stated;
  stated.rotation_D[0] = 1.0;
  bool isRead = false;
  {
    const CallGuard mark(channel_, Function::read);
    isRead = library_.functions().read(library_.device(), &stated) == 0;
  }
  newest_.isFaulty = isRead && !isFinite(stated) ? 1 : 0;
  newest_.faulty += newest_.isFaulty;
  // A sample that is not finite is none: the last one stays, and is stale after three periods.
  if (newest_.isFaulty != 0) return;
  DeviceSample& sample = newest_.sample;
  sample.isValid = isRead && stated.is_valid != 0 && newest_.isRefusing == 0 ? 1 : 0;
  if (!isRead) return;
  sample.sequence = stated.sequence;
  std::copy_n(stated.position_D_m, 3, sample.position_D.begin());
  std::copy_n(stated.rotation_D, 4, sample.rotation_D.begin());
  sample.buttons = stated.buttons;
}

}  // namespace perilymph::device::plugin
