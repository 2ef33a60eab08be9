// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/CouplingLimit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>

#include "perilymph/foundation/Math.h"
#include "perilymph/haptics/SampleValidator.h"

namespace perilymph::haptics {

namespace {

// A handle of 90 g with damping 0.5 N.s/m: lighter and less damped than the devices in use.
constexpr double lightHandle = 0.09;   // [kg]
constexpr double freeHandle = 0.5;     // [N.s/m]
constexpr double usedFraction = 0.75;  // of the damping, used by the spring
constexpr double eulersNumber = 2.718281828459045;

std::string text(const char* format, double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

}  // namespace

bool followsReports(const device::DeviceTraits& traits, double timeStep) noexcept
{
  const double ticksEach = traits.nominalPeriod / timeStep;
  return traits.reporting == device::Reporting::periodic && ticksEach > 0.9 && ticksEach < 1.1;
}

double delayOf(const device::DeviceTraits& traits, double timeStep) noexcept
{
  // A report that triggers a tick is used at once; otherwise it waits half a period on average.
  const double wait = followsReports(traits, timeStep) ? 0.0 : 0.5 * traits.nominalPeriod;
  return std::max(0.0, traits.transportDelay) + wait;
}

double passiveHandleDamping(double stiffness, double damping, double delay, double timeStep)
{
  using Complex = std::complex<double>;
  constexpr int frequencies = 4'000;
  const double fraction = timeStep / (SampleValidator::velocityLag + timeStep);
  double needed = 0.0;
  for (int k = 1; k <= frequencies; ++k) {
    const double turn = pi * k / frequencies;  // w T
    const Complex back = std::polar(1.0, -turn);
    const Complex smoothing = fraction / (1.0 - (1.0 - fraction) * back);
    const Complex law = (stiffness + damping * smoothing * (1.0 - back) / timeStep) *
                        std::polar(1.0, -turn * delay / timeStep);
    needed = std::max(
        needed, 0.5 * timeStep * ((1.0 - back) * law).real() / (1.0 - sineCosine(turn).cosine));
  }
  return needed;
}

CouplingLimit couplingLimit(const device::DeviceTraits& traits, double timeStep)
{
  CouplingLimit limit;
  if (!traits.rendersForce) return limit;
  const double damping = traits.handleDamping > 0.0 ? traits.handleDamping : freeHandle;
  const double mass = traits.handleMass > 0.0 ? traits.handleMass : lightHandle;

  const double late = 0.5 * timeStep + delayOf(traits, timeStep);
  limit.stiffness = usedFraction * damping / late;
  limit.damping = mass / (eulersNumber * (late + SampleValidator::velocityLag));
  limit.reason = "a force reaches the hand " + text("%.2f", late * 1e3) + " ms late";
  if (traits.maxStiffness > 0.0 && traits.maxStiffness < limit.stiffness) {
    limit.stiffness = traits.maxStiffness;
    limit.reason = "its maker gives no more";
  }
  if (traits.maxDamping > 0.0) limit.damping = std::min(limit.damping, traits.maxDamping);
  return limit;
}

std::string couplingSentence(double asked, const CouplingLimit& limit, const std::string& device)
{
  if (!(asked > limit.stiffness)) return {};
  return device + " renders " + text("%.0f", limit.stiffness) + " N/m of the " +
         text("%.0f", asked) + " N/m asked for, because " + limit.reason +
         ". What is felt is softer; the forces that are recorded stay physical.";
}

}  // namespace perilymph::haptics
