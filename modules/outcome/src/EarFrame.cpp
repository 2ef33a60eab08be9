// SPDX-License-Identifier: BSD-3-Clause
#include "EarFrame.h"

#include <algorithm>
#include <cmath>

#include "perilymph/anatomy/ScalaVestibuli.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::outcome {

namespace {

constexpr double sectionStep = 2.0 * pi / 180.0;
/// Center of both scalae above that of the scala tympani, as a part of its height: both are about equally
/// high (mirror image of the scala tympani, anatomy::vestibuliOf()).
constexpr double upward = 0.5;
constexpr double nearDuct_mm = 1.5;  // across the duct: half its width and the blur of metal in it
constexpr double nearOpening_mm = 3.0;  // from the opening's axis
constexpr double beforeWindow =
    25.0 * pi / 180.0;  // the first section also stands for points before the window

}  // namespace

EarFrame::EarFrame(const Ear& ear)
    : axes_(ear.measures.anatomyAxes_PW),
      origin_(ear.measures.anatomyOrigin_P),
      entry_(ear.scala->entry()),
      both_(anatomy::bothScalaeOf(*ear.scala)),
      lastAngle_(ear.scala->lastAngle().si()),
      step_(sectionStep),
      leadIn_mm_(inMillimeters(ear.scala->leadIn()))
{
  double length = leadIn_mm_;
  Eigen::Vector3d former = Eigen::Vector3d::Zero();
  for (double angle = 0.0; angle <= lastAngle_ + sectionStep; angle += sectionStep) {
    const anatomy::Section section = ear.scala->section(std::min(angle, lastAngle_));
    const Eigen::Vector3d center = 1e3 * ear.scala->center_W(std::min(angle, lastAngle_));
    if (!depth_.empty()) length += (center - former).norm();
    former = center;
    radius_.push_back(1e3 * section.centerRadius);
    height_.push_back(
        1e3 * (section.centerHeight + upward * 0.5 * (section.roofHeight - section.floorHeight)));
    depth_.push_back(length);
  }
}

double EarFrame::depthAt(double angle) const
{
  const double x = std::clamp(angle / step_, 0.0, static_cast<double>(depth_.size() - 2));
  const auto i = static_cast<std::size_t>(x);
  return depth_[i] + (x - static_cast<double>(i)) * (depth_[i + 1] - depth_[i]);
}

double EarFrame::bonePart(const Eigen::Vector3d& point_P, double blur_mm) const
{
  constexpr double farFrom_mm = 2.5, centerOf_mm = 0.5, edge = 1.6;
  const EarPlace place = placeOf(point_P);
  if (!place.isInside || place.angle < 0.0 || place.across_mm > farFrom_mm) return 1.0;
  const Eigen::Vector3d point_W = toW(point_P);
  const SineCosine direction = sineCosine(place.angle);
  anatomy::LumenTrack track{false, place.angle, {direction.cosine, direction.sine}};
  const double reach = 2e-3;
  anatomy::WallPoint wall;
  both_->nearestWall({&point_W, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
  if (!wall.isNear) return place.across_mm < centerOf_mm ? 0.0 : 1.0;
  return 0.5 - 0.5 * std::clamp(1e3 * wall.distance / (edge * blur_mm), -1.0, 1.0);
}

EarPlace EarFrame::placeOf(const Eigen::Vector3d& point_P) const
{
  const Eigen::Vector3d point_W = toW(point_P);
  const double r = 1e3 * point_W.head<2>().norm(), z = 1e3 * point_W.z();
  double first = arcTangent(point_W.y(), point_W.x());
  if (first < -beforeWindow) first += 2.0 * pi;
  EarPlace best;
  double nearest = 1e9;
  for (double angle = first; angle < lastAngle_ + 0.2; angle += 2.0 * pi) {
    const double x = std::clamp(angle / step_, 0.0, static_cast<double>(radius_.size() - 1));
    const auto i = static_cast<std::size_t>(x);
    const double across = std::hypot(r - radius_[i], z - height_[i]);
    if (across >= nearest) continue;
    nearest = across;
    best.angle = angle;
  }
  best.across_mm = nearest;
  best.radius_mm = r;
  best.isNearDuct = nearest < nearDuct_mm;
  best.depth_mm = depthAt(best.angle) + std::min(0.0, best.angle) * r;
  // in front of the opening
  const double behind_mm = 1e3 * (entry_.origin_W - point_W).dot(entry_.out_W);
  const Eigen::Vector3d off = point_W - entry_.origin_W;
  const double besideAxis_mm = 1e3 * (off - off.dot(entry_.out_W) * entry_.out_W).norm();
  const bool isBesideOpening = besideAxis_mm < nearOpening_mm + std::max(0.0, -behind_mm);
  if (behind_mm <= leadIn_mm_ && isBesideOpening && besideAxis_mm < nearest) {
    best.depth_mm = behind_mm;
    best.isInside = behind_mm > 0.0;
    best.angle = std::min(first, 0.0);
    best.isNearDuct = true;
    best.across_mm = besideAxis_mm;
  } else {
    best.isInside = true;
  }
  return best;
}

}  // namespace perilymph::outcome
