// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/Registration.h"

namespace perilymph::haptics {

namespace {

void add(Hash& hash, const Eigen::Vector3d& vector) noexcept
{
  for (int i = 0; i < 3; ++i) hash.add(vector[i]);
}

}  // namespace

Registration::Registration(const anatomy::Entry& entry, const Eigen::Vector3d& approach_W,
                           double motionScale)
    : motionScale_(motionScale)
{
  rotation_WD_.col(0) = entry.outward_W;
  rotation_WD_.col(1) = entry.vertical_W;
  rotation_WD_.col(2) = entry.out_W;
  if (approach_W == -entry.out_W) return;
  const Eigen::Vector3d out_W = -approach_W.normalized();
  const Eigen::Vector3d outward_W =
      (entry.outward_W - entry.outward_W.dot(out_W) * out_W).normalized();
  rotation_WD_.col(0) = outward_W;
  rotation_WD_.col(1) = out_W.cross(outward_W);
  rotation_WD_.col(2) = out_W;
}

void Registration::anchor(const HandState& hand, const BasePose& pose) noexcept
{
  handAtAnchor_D_ = hand.position_D;
  rotationAtAnchor_D_ = hand.rotation_D;
  anchor_ = pose;
  // Rounding errors must not accumulate over many clutches: keep the frame orthonormal.
  anchor_.axis_W.normalize();
  anchor_.curl_W -= anchor_.axis_W.dot(anchor_.curl_W) * anchor_.axis_W;
  anchor_.curl_W.normalize();
}

BasePose Registration::pose(const HandState& hand) const noexcept
{
  BasePose pose = anchor_;
  pose.position_W += toCochlea(motionScale_ * (hand.position_D - handAtAnchor_D_));
  const Eigen::Quaterniond turned_D = hand.rotation_D * rotationAtAnchor_D_.conjugate();
  pose.axis_W = toCochlea(turned_D * toDevice(anchor_.axis_W)).normalized();
  pose.curl_W = toCochlea(turned_D * toDevice(anchor_.curl_W)).normalized();
  return pose;
}

Eigen::Vector3d Registration::toCochlea(const Eigen::Vector3d& vector_D) const noexcept
{
  return rotation_WD_ * vector_D;
}

Eigen::Vector3d Registration::toDevice(const Eigen::Vector3d& vector_W) const noexcept
{
  return rotation_WD_.transpose() * vector_W;
}

void Registration::addTo(Hash& hash) const noexcept
{
  add(hash, handAtAnchor_D_);
  for (int i = 0; i < 4; ++i) hash.add(rotationAtAnchor_D_.coeffs()[i]);
  add(hash, anchor_.position_W);
  add(hash, anchor_.axis_W);
  add(hash, anchor_.curl_W);
}

}  // namespace perilymph::haptics
