// SPDX-License-Identifier: BSD-3-Clause
#include "RandomHand.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace perilymph::test {

double RandomNumbers::within(double low, double high)
{
  state_ += 0x9e3779b97f4a7c15;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  z ^= z >> 31;
  return low + (high - low) * static_cast<double>(z >> 11) * 0x1p-53;
}

RandomHand::RandomHand(const mechanics::InsertionModel& model, HandLimits limits, StyletUse stylet,
                       std::uint64_t seed)
    : model_(model), random_(seed), limits_(limits), stylet_(stylet), last_W_(model.startBase_W)
{
  const electrode::ArrayDesign& array = model.parts.array;
  const double start = model.parts.startInside.si();
  pullDepth_ = random_.within(0.0, array.insertable.si());
  pullSpeed_ = random_.within(1e-3, 50e-3);
  for (double& phase : tremorPhase_) phase = random_.within(0.0, 6.28);
  advance_ = {0.0, -limits.before - start, array.insertable.si() - start, limits.fastest};
  for (Wanderer& beside : beside_) beside = {0.0, -limits.lateral, limits.lateral, 5e-3};
  for (Wanderer& tilt : tilt_) tilt = {0.0, -limits.tilt, limits.tilt, 0.5};
  roll_ = {0.0, -limits.roll, limits.roll, 1.5};
}

void RandomHand::wander(Wanderer& wanderer)
{
  const double dt = model_.timeStep;
  if (--wanderer.left <= 0) {
    // speeds over three decades, so that slow and fast both happen
    const double fraction = std::pow(10.0, random_.within(-3.0, 0.0));
    wanderer.speed = random_.within(0.0, 1.0) < 0.45 ? -fraction : fraction;
    wanderer.speed *= wanderer.fastest;
    wanderer.left = static_cast<int>(random_.within(5e-3, 400e-3) / dt) + 1;
  }
  wanderer.value += wanderer.speed * dt;
  if (wanderer.value < wanderer.low || wanderer.value > wanderer.high) {
    wanderer.value = std::clamp(wanderer.value, wanderer.low, wanderer.high);
    wanderer.speed = -wanderer.speed;
  }
}

double RandomHand::withdrawal(const mechanics::InsertionState& state)
{
  const electrode::ArrayDesign& array = model_.parts.array;
  const double depth = state.readings.depth;
  const double length = array.length.si();
  if (stylet_ == StyletUse::out) return length;
  if (stylet_ == StyletUse::pulled && (withdrawal_ > 0.0 || depth > pullDepth_))
    withdrawal_ = std::min(length, withdrawal_ + pullSpeed_ * model_.timeStep);
  if (stylet_ == StyletUse::held && array.stylet.holdDepth)
    withdrawal_ = std::clamp(depth - model_.styletFromTip - array.stylet.holdDepth->si(),
                             withdrawal_, length);
  return withdrawal_;
}

mechanics::Drive RandomHand::next(const mechanics::InsertionState& state)
{
  time_ += model_.timeStep;
  wander(advance_);
  for (Wanderer& beside : beside_) wander(beside);
  for (Wanderer& tilt : tilt_) wander(tilt);
  wander(roll_);
  const auto tremor = [&](int axis) {
    // sets in over 0.1 s: the first tick starts from rest
    return limits_.tremor * std::min(1.0, time_ / 0.1) *
           std::sin(2.0 * 3.14159265358979 * 8.0 * time_ + tremorPhase_[axis]);
  };

  const Eigen::Vector3d axis = model_.startAxis_W;
  const Eigen::Vector3d curl = model_.startCurl_W;
  const Eigen::Vector3d side = axis.cross(curl);
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(tilt_[0].value, curl) * Eigen::AngleAxisd(tilt_[1].value, side) *
       Eigen::AngleAxisd(roll_.value, axis))
          .toRotationMatrix();
  mechanics::Drive drive;
  drive.handAxis_W = (turn * axis).normalized();
  drive.handCurl_W = turn * curl;
  drive.handCurl_W -= drive.handCurl_W.dot(drive.handAxis_W) * drive.handAxis_W;
  drive.handCurl_W.normalize();
  const double outside = (model_.entry.origin_W - model_.startBase_W).dot(axis);
  drive.handPosition_W =
      model_.entry.origin_W + (advance_.value + tremor(0) - outside) * drive.handAxis_W +
      (beside_[0].value + tremor(1)) * curl + (beside_[1].value + tremor(2)) * side;
  drive.handVelocity_W = (drive.handPosition_W - last_W_) / model_.timeStep;
  last_W_ = drive.handPosition_W;
  drive.styletWithdrawal = withdrawal(state);
  return drive;
}

}  // namespace perilymph::test
