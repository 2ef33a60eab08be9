// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/PointerDevice.h"

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Math.h"
#include "virtual/TimeStep.h"

namespace perilymph::device {

namespace {

// Ten times the published insertion speed: fast enough for work, slow enough for the rod.
constexpr double maxSpeed = 20e-3;  // [m/s]
// Natural frequency of the motion; settling time about 6 / w = 0.3 s.
constexpr double quickness = 20.0;  // [1/s]
// Sufficient to brake from maximum speed without overshoot: w times the maximum speed.
constexpr double maxAcceleration = quickness * maxSpeed;  // [m/s^2]
constexpr double maxRollSpeed = 2.0;                      // [rad/s]
constexpr double maxRollAcceleration = quickness * maxRollSpeed;

/// Limits the length of a 3-vector.
void limit(std::array<double, 3>& vector, double limit) noexcept
{
  const double squared = vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2];
  if (squared <= limit * limit) return;
  const double scale = limit / std::sqrt(squared);
  for (double& component : vector) component *= scale;
}

double pull(double wanted, double place, double velocity) noexcept
{
  return quickness * quickness * (wanted - place) - 2.0 * quickness * velocity;
}

void add(std::atomic<double>& asked, double more) noexcept
{
  if (std::isfinite(more)) asked.fetch_add(more);
}

}  // namespace

PointerDevice::PointerDevice(double timeStep) : timeStep_(checkedTimeStep(timeStep))
{
  sample_.isValid = 1;
}

void PointerDevice::advanceBy(double distance) noexcept { add(askedAdvance_, distance); }

void PointerDevice::driveAt(double velocity, double maxDistance) noexcept
{
  if (!std::isfinite(velocity) || !std::isfinite(maxDistance)) return;
  askedVelocity_ = std::clamp(velocity, -maxSpeed, maxSpeed);
  askedDistance_ = std::max(0.0, maxDistance);
}

/// Motion of the target by the drive in one time step [m].
double PointerDevice::driven() noexcept
{
  const double velocity = askedVelocity_;
  const double distance = askedDistance_.exchange(-1.0);
  if (distance >= 0.0) {
    driveDistance_ = distance;
    driveTime_ = longestDrive_s;
  }
  if (driveTime_ <= 0.0) return 0.0;
  driveTime_ -= timeStep_;
  const double step = std::min(std::abs(velocity) * timeStep_, driveDistance_);
  driveDistance_ -= step;
  return velocity < 0.0 ? -step : step;
}

void PointerDevice::shiftBy(double right, double up) noexcept
{
  add(askedRight_, right);
  add(askedUp_, up);
}

void PointerDevice::rollBy(double angle) noexcept { add(askedRoll_, angle); }

void PointerDevice::grasp(bool held) noexcept { isHeld_ = held; }

DeviceTraits PointerDevice::traits() const
{
  DeviceTraits traits;
  traits.name = Sentence{"Mouse and keyboard"};
  traits.nominalPeriod = timeStep_;
  return traits;
}

Result<void> PointerDevice::open() { return {}; }

void PointerDevice::close() noexcept { isHeld_ = false; }

DeviceSample PointerDevice::read() noexcept
{
  const bool held = isHeld_;
  const std::array<double, 4> asked{askedAdvance_.exchange(0.0) + driven(),
                                    askedRight_.exchange(0.0), askedUp_.exchange(0.0),
                                    askedRoll_.exchange(0.0)};
  for (std::size_t i = 0; i < asked.size(); ++i)
    wanted_[i] = held ? wanted_[i] + asked[i] : place_[i];

  // translation: the limits apply to the vector, not to each axis
  std::array<double, 3> acceleration{};
  for (std::size_t i = 0; i < 3; ++i) acceleration[i] = pull(wanted_[i], place_[i], velocity_[i]);
  limit(acceleration, maxAcceleration);
  std::array<double, 3> velocity{};
  for (std::size_t i = 0; i < 3; ++i) velocity[i] = velocity_[i] + acceleration[i] * timeStep_;
  limit(velocity, maxSpeed);
  std::copy(velocity.begin(), velocity.end(), velocity_.begin());

  // roll
  const double rollPull = pull(wanted_[3], place_[3], velocity_[3]);
  velocity_[3] += std::clamp(rollPull, -maxRollAcceleration, maxRollAcceleration) * timeStep_;
  velocity_[3] = std::clamp(velocity_[3], -maxRollSpeed, maxRollSpeed);

  for (std::size_t i = 0; i < place_.size(); ++i) place_[i] += velocity_[i] * timeStep_;

  const SineCosine half = sineCosine(0.5 * place_[3]);
  sample_.position_D = {place_[1], place_[2], -place_[0]};
  sample_.rotation_D = {half.cosine, 0.0, 0.0, half.sine};
  sample_.buttons = held ? graspButton : 0u;
  ++sample_.sequence;
  return sample_;
}

void PointerDevice::write(const Wrench&) noexcept {}

}  // namespace perilymph::device
