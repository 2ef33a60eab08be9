// SPDX-License-Identifier: BSD-3-Clause
#include "ContactMarks.h"

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "ForceColors.h"

namespace perilymph::visualization {
namespace {

constexpr double glowRadius_mm = 0.24;
constexpr double minShown_mN = 2.0;  ///< Smaller arrows would be specks.
constexpr double minFriction_mN = 0.4;
constexpr double longestArrow_mm = 2.0;
constexpr double arrowLift_mm =
    0.0;  ///< In depth where they are: the array covers them, not they its contacts.

}  // namespace

void ContactMarks::addGlow(vtkRenderer& renderer) { renderer.AddActor(&glow_.actor()); }
void ContactMarks::addArrows(vtkRenderer& renderer) { renderer.AddActor(&arrows_.actor()); }

void ContactMarks::setVisible(bool glow, bool arrows)
{
  glow_.actor().SetVisibility(glow);
  arrows_.actor().SetVisibility(arrows);
}

void ContactMarks::build(const ContactField& field, const ArrayParts& array, const ArrayPath& path,
                         const ViewFrame& view)
{
  buildGlow(field, view);

  arrows_.clear();
  arrowCount_ = 0;
  Eigen::Vector3d force_mN = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // of positions, weighted by force
  double total_mN = 0.0, friction_mN = 0.0;
  double end_mm = arrowEvery_mm;
  for (const ContactStation& station : field.stations()) {
    if (station.fromTip_mm >= end_mm || &station == &field.stations().back()) {
      if (force_mN.norm() > minShown_mN) {
        addArrow(moment / total_mN, arrow_mm_mN * force_mN, palette_.arrow, view);
        ++arrowCount_;
      }
      if (std::abs(friction_mN) > minFriction_mN) {
        // beside the array, at the contact
        const double middle_mm = end_mm - 0.5 * arrowEvery_mm;
        const PathPoint middle = path.at(middle_mm);
        const Eigen::Vector3d wall = -array.radius_mm(middle_mm) * force_mN.normalized();
        addArrow(middle.place + wall, frictionArrow_mm_mN * friction_mN * middle.along,
                 palette_.frictionArrow, view);
      }
      force_mN.setZero();
      moment.setZero();
      total_mN = friction_mN = 0.0;
      end_mm += arrowEvery_mm;
    }
    if (station.force_mN_mm <= 0.0) continue;
    const double station_mN = station.force_mN_mm * ContactField::spacing_mm;
    force_mN += station_mN * station.inward;
    friction_mN += station.friction_mN_mm * ContactField::spacing_mm;
    // arrows start on the side of the array opposite the wall
    const double across_mm = 2.0 * array.radius_mm(station.fromTip_mm);
    moment += station_mN * (station.wall + across_mm * station.inward);
    total_mN += station_mN;
  }
  arrows_.build(view, arrowLift_mm);
}

void ContactMarks::buildGlow(const ContactField& field, const ViewFrame& view)
{
  glow_.clear();
  for (const ContactStation& station : field.stations()) {
    if (station.force_mN_mm <= 0.0) continue;
    // Dots overlap: with this opacity each, their sum is close to the map's.
    Rgba color = forceColor(station.force_mN_mm, palette_.scheme);
    color[3] = static_cast<unsigned char>(0.42 * color[3]);
    glow_.add(station.wall, color, glowRadius_mm);
  }
  glow_.build(view, 0.05);
}

void ContactMarks::addArrow(const Eigen::Vector3d& from, const Eigen::Vector3d& arrow_mm,
                            const Rgba& color, const ViewFrame& view)
{
  const double length_mm = std::min(longestArrow_mm, arrow_mm.norm());
  const Eigen::Vector3d direction = arrow_mm.normalized();
  const double head_mm = std::min(0.6 * length_mm, 10.0 * view.pixel_mm);
  const Eigen::Vector3d neck = from + (length_mm - head_mm) * direction;
  const Eigen::Vector3d tip = from + length_mm * direction;
  const double shaft = 0.9 * view.pixel_mm;
  arrows_.begin(LineEdge::firm);
  arrows_.add({from, color, shaft});
  arrows_.add({neck, color, shaft});
  arrows_.begin(LineEdge::firm);
  arrows_.add({neck, color, 0.45 * head_mm});
  arrows_.add({tip, color, 0.1 * view.pixel_mm});
}

}  // namespace perilymph::visualization
