// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/SampleValidator.h"

#include <algorithm>
#include <cmath>

namespace perilymph::haptics {

namespace {

constexpr double farthest = 10.0;    // [m]; beyond the reach of any device
constexpr double maxSpeed = 1.0;     // [m/s]; five times the fastest motion in use
constexpr double maxTurning = 30.0;  // [rad/s]

bool isPlausible(const device::DeviceSample& sample) noexcept
{
  for (const double x : sample.position_D)
    if (!(std::abs(x) <= farthest)) return false;  // also catches NaN
  double squared = 0.0;
  for (const double q : sample.rotation_D) {
    if (!(std::abs(q) <= 2.0)) return false;
    squared += q * q;
  }
  return squared >= 0.25 && squared <= 4.0;
}

Eigen::Quaterniond rotationOf(const device::DeviceSample& sample) noexcept
{
  const auto& q = sample.rotation_D;
  const double scale = 1.0 / std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] * scale, q[1] * scale, q[2] * scale, q[3] * scale};
}

}  // namespace

double SampleValidator::staleTime(double samplePeriod) noexcept
{
  return std::clamp(3.0 * samplePeriod, 3e-3, 30e-3);
}

SampleValidator::SampleValidator(double timeStep, double samplePeriod) : timeStep_(timeStep)
{
  const double ticks = std::ceil(staleTime(samplePeriod) / timeStep - 1e-6);
  staleTicks_ = static_cast<std::uint64_t>(std::max(ticks, 1.0));
  ticksWithout_ = staleTicks_;
}

bool SampleValidator::isFresh(const device::DeviceSample& sample) noexcept
{
  if (sample.isValid == 0) return false;
  const bool isNew = !hasSequence_ || sample.sequence != sequence_;
  hasSequence_ = true;
  sequence_ = sample.sequence;
  return isNew;
}

void SampleValidator::follow(const Eigen::Vector3d& position_D,
                             const Eigen::Quaterniond& rotation_D) noexcept
{
  const double elapsed = static_cast<double>(ticksWithout_ + 1) * timeStep_;
  const Eigen::Vector3d moved_D = position_D - hand_.position_D;
  const double alike = hand_.rotation_D.dot(rotation_D);
  // sine squared of half the rotation angle
  const double turnedSquared = std::max(0.0, 1.0 - alike * alike);
  const double maxHalfTurn = std::min(0.5 * maxTurning * elapsed, 1.0);

  const bool isTooFar = moved_D.squaredNorm() > maxSpeed * maxSpeed * elapsed * elapsed;
  const bool isTurnedTooFar = turnedSquared > maxHalfTurn * maxHalfTurn;
  const bool isImpossible = hand_.isStale || isTooFar || isTurnedTooFar;
  hand_.hasJumped = hasPlace_ && isImpossible;
  hasPlace_ = true;
  if (isImpossible) {
    rawVelocity_D_.setZero();
  } else {
    hand_.moved_D = moved_D;
    rawVelocity_D_ = moved_D / elapsed;
  }
  hand_.position_D = position_D;
  hand_.rotation_D = rotation_D;
}

const HandState& SampleValidator::take(const device::DeviceSample& sample) noexcept
{
  const bool fresh = isFresh(sample);
  const bool accepted = fresh && isPlausible(sample);
  const bool isPressed = (sample.buttons & device::graspButton) != 0;

  hand_.moved_D.setZero();
  hand_.hasJumped = false;
  hand_.isRejected = fresh && !accepted;
  hand_.isLost = sample.isValid == 0;
  if (accepted) {
    follow({sample.position_D[0], sample.position_D[1], sample.position_D[2]}, rotationOf(sample));
    hand_.isHeld = isPressed;
    ticksWithout_ = 0;
  } else {
    hand_.isHeld = hand_.isHeld && isPressed && !hand_.isLost;
    ticksWithout_ = std::min(ticksWithout_ + 1, staleTicks_);
  }

  hand_.isStale = ticksWithout_ >= staleTicks_;
  if (hand_.isStale) rawVelocity_D_.setZero();
  const double fraction = timeStep_ / (velocityLag + timeStep_);
  hand_.velocity_D += fraction * (rawVelocity_D_ - hand_.velocity_D);
  if (hand_.isStale || hand_.hasJumped) hand_.velocity_D.setZero();
  return hand_;
}

void SampleValidator::addTo(Hash& hash) const noexcept
{
  hash.add(ticksWithout_);
  hash.add(sequence_);
  hash.add(hasSequence_);
  hash.add(hasPlace_);
  for (int i = 0; i < 3; ++i) {
    hash.add(rawVelocity_D_[i]);
    hash.add(hand_.position_D[i]);
    hash.add(hand_.velocity_D[i]);
  }
  for (int i = 0; i < 4; ++i) hash.add(hand_.rotation_D.coeffs()[i]);
  hash.add(hand_.isHeld);
  hash.add(hand_.isStale);
}

}  // namespace perilymph::haptics
