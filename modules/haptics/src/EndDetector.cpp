// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/EndDetector.h"

#include <algorithm>
#include <cmath>

namespace perilymph::haptics {

namespace {

// Far below measurable lengths; above rounding errors.
constexpr double atBone = 1e-9;  // [m]

}  // namespace

double distanceToBone(const mechanics::InsertionModel& model, const Eigen::Vector3d& base_W,
                      const Eigen::Vector3d& inward_W) noexcept
{
  const double height =
      (base_W - model.entry.origin_W).dot(model.entry.out_W) - model.radius.front();
  return std::max(0.0, height) / std::max(-inward_W.dot(model.entry.out_W), 0.5);
}

EndDetector::EndDetector(const mechanics::InsertionModel& model, double stopForce) noexcept
    : stopForce_(stopForce),
      isRod_(model.parts.kind == mechanics::ModelKind::rod),
      tipNodes_(
          std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(limits_.tip / model.spacing)),
                                  1, static_cast<std::size_t>(model.nodes - 1))),
      stallTip_W_(model.startBase_W + model.parts.array.length.si() * model.startAxis_W),
      stallDepth_(std::max(0.0, model.parts.startInside.si()))
{
  const anatomy::LumenTrack start = model.parts.lumen->startTrack();
  const Eigen::Vector3d counterclockwise_W(-start.direction[1], start.direction[0], 0.0);
  sense_ = counterclockwise_W.dot(model.entry.out_W) > 0.0 ? -1.0 : 1.0;
}

InsertionEnd EndDetector::detect(const mechanics::InsertionModel& model,
                                 const mechanics::InsertionState& state,
                                 bool isWithdrawing) noexcept
{
  const mechanics::Readings& now = state.readings;
  // the force of a step that is not balanced is none of the array
  const bool isBalanced = !state.isSettling;
  if (isBalanced && now.handForce_W.squaredNorm() > maxHandForce * maxHandForce)
    return InsertionEnd::jammed;
  if (isWithdrawing) return InsertionEnd::none;
  if (isBalanced && stopForce_ > 0.0 && now.axialForce >= stopForce_)
    return InsertionEnd::stoppedByResistance;
  if (!isRod_) return InsertionEnd::none;

  const double outside = model.parts.array.length.si() - now.depth;
  const double slack = outside - (state.base_W - model.openingCenter_W).norm();
  const bool isAtBone = distanceToBone(model, state.base_W, -model.entry.out_W) <= atBone;
  if (!(now.depth > 0.0))
    return slack > limits_.slippedSlack || isAtBone ? InsertionEnd::outOfOpening
                                                    : InsertionEnd::none;
  if (slack > limits_.maxSlack || isAtBone) return InsertionEnd::buckled;
  if (isTipFolded(model, state)) return InsertionEnd::foldedTip;
  if (isStalled(state.position_W.back(), now.depth)) return InsertionEnd::jammed;
  return InsertionEnd::none;
}

bool EndDetector::isTipFolded(const mechanics::InsertionModel& model,
                              const mechanics::InsertionState& state) const noexcept
{
  const Eigen::Vector3d tip_W =
      state.position_W.back() - state.position_W[state.position_W.size() - 1 - tipNodes_];
  const anatomy::LumenTrack& track = state.track.back();
  const Eigen::Vector3d along_W =
      track.inLeadIn
          ? Eigen::Vector3d(-model.entry.out_W)
          : Eigen::Vector3d(-sense_ * track.direction[1], sense_ * track.direction[0], 0.0);
  return tip_W.dot(along_W) < -0.5 * tip_W.norm();
}

bool EndDetector::isStalled(const Eigen::Vector3d& tip_W, double depth) noexcept
{
  const bool hasMoved =
      (tip_W - stallTip_W_).squaredNorm() > limits_.minAdvance * limits_.minAdvance;
  if (hasMoved) stallTip_W_ = tip_W;
  if (hasMoved || depth < stallDepth_) stallDepth_ = depth;
  return depth - stallDepth_ > limits_.maxStall;
}

void EndDetector::addTo(Hash& hash) const noexcept
{
  hash.add(stallDepth_);
  for (int i = 0; i < 3; ++i) hash.add(stallTip_W_[i]);
}

}  // namespace perilymph::haptics
