// SPDX-License-Identifier: BSD-3-Clause
#include "ContactField.h"

#include <algorithm>
#include <cmath>

namespace perilymph::visualization {

ContactField::ContactField(Length arrayLength)
{
  const int count = static_cast<int>(std::lround(inMillimeters(arrayLength) / spacing_mm)) + 1;
  stations_.resize(static_cast<std::size_t>(std::max(count, 1)));
  for (std::size_t i = 0; i < stations_.size(); ++i)
    stations_[i].fromTip_mm = spacing_mm * static_cast<double>(i);
}

void ContactField::clear()
{
  for (ContactStation& station : stations_) {
    station.force_mN_mm = 0.0;
    station.friction_mN_mm = 0.0;
    station.inward.setZero();
  }
  isTouching_ = false;
}

void ContactField::follow(const haptics::Snapshot& now, const PictureSpace& space,
                          const ArrayPath& path, const ArrayParts& array)
{
  clear();
  const std::uint32_t nodes = std::min<std::uint32_t>(now.nodes, mechanics::maxNodes);
  for (std::uint32_t i = 0; i < nodes; ++i) {
    const double force_mN = 1e3 * static_cast<double>(now.normalForce[i]);
    if (!(force_mN > 0.0) || !std::isfinite(force_mN)) continue;
    const double fromTip_mm = path.length_mm() * (1.0 - static_cast<double>(i) / (nodes - 1));

    // The wall's force is normal and friction; friction acts along the array, so the perpendicular
    // component has the direction of the normal. At the tip, which may hit the wall head on, the
    // whole force counts.
    const std::array<float, 3>& whole = now.wallForce_W[i];
    Eigen::Vector3d inward = space.direction({whole[0], whole[1], whole[2]});
    double friction = 0.0;
    if (i + 1 < nodes) {
      const Eigen::Vector3d along = path.at(fromTip_mm).along;
      friction = inward.dot(along);
      inward -= friction * along;
    }
    const double length = inward.norm();
    if (length > 0.0 && std::isfinite(length))
      spread(fromTip_mm, force_mN, 1e3 * friction, inward / length);
  }
  if (!isTouching_) return;

  for (ContactStation& station : stations_) {
    const double length = station.inward.norm();
    if (length <= 0.0) continue;
    station.inward /= length;
    const PathPoint point = path.at(station.fromTip_mm);
    station.wall = point.place - array.radius_mm(station.fromTip_mm) * station.inward;
  }
}

void ContactField::spread(double fromTip_mm, double force_mN, double friction_mN,
                          const Eigen::Vector3d& inward)
{
  const int last = static_cast<int>(stations_.size()) - 1;
  const int from = std::max(0, static_cast<int>(std::ceil((fromTip_mm - reach_mm) / spacing_mm)));
  const int to = std::min(last, static_cast<int>(std::floor((fromTip_mm + reach_mm) / spacing_mm)));
  double sum = 0.0;
  for (int i = from; i <= to; ++i)
    sum += bell(stations_[static_cast<std::size_t>(i)].fromTip_mm - fromTip_mm, reach_mm);
  if (sum <= 0.0) return;

  // The part beyond the array's end is distributed to the other stations, so that they carry the
  // whole force.
  for (int i = from; i <= to; ++i) {
    ContactStation& station = stations_[static_cast<std::size_t>(i)];
    const double weight = bell(station.fromTip_mm - fromTip_mm, reach_mm) / sum;
    station.force_mN_mm += force_mN * weight / spacing_mm;
    station.friction_mN_mm += friction_mN * weight / spacing_mm;
    station.inward += force_mN * weight * inward;
  }
  isTouching_ = true;
}

}  // namespace perilymph::visualization
