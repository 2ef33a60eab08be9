// SPDX-License-Identifier: BSD-3-Clause
#include "GhostArray.h"

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace perilymph::visualization {
namespace {

constexpr double step_mm = 0.06;
constexpr int dashSteps = 7, gapSteps = 5;  ///< Dashes of 0.42 mm with gaps of 0.30 mm.
constexpr double bandOpacity = 0.30;
constexpr double lineWidth_px = 1.0;  ///< Half the width of the outline.
constexpr double lift_mm = 1.3;       ///< The outline is above, the band below the inserted array.

/// Point on the edge of the array in the picture plane, at the left (-1) or right (1).
Eigen::Vector3d edgeOf(const PathPoint& point, double radius_mm, double side, const ViewFrame& view)
{
  const Eigen::Vector3d across = point.along.cross(view.back);
  const double visible = across.norm();  // 0 where the array points toward the viewer
  if (visible < 1e-6) return point.place;
  return point.place + (side * radius_mm / visible) * across;
}

}  // namespace

GhostArray::GhostArray(const SceneColors& palette) : palette_(palette)
{
  band_.actor().VisibilityOff();
  outline_.actor().VisibilityOff();
}

void GhostArray::addTo(vtkRenderer& renderer)
{
  renderer.AddActor(&band_.actor());
  renderer.AddActor(&outline_.actor());
}

void GhostArray::show(const electrode::ArrayDesign& array, std::span<const Eigen::Vector3d> nodes_W,
                      const PictureSpace& space)
{
  line_.clear();
  contacts_.clear();
  ArrayPath path(array.length);
  path.follow(nodes_W, space);
  const double length_mm = inMillimeters(array.length);
  if (!path.isEmpty() && length_mm > 0.0) {
    const double tip_mm = inMillimeters(array.tipRadius());
    const auto pointAt = [&](double fromTip_mm, bool isDash) {
      const double full_mm =
          0.5 * inMillimeters(array.diameter.at(millimeters(std::max(fromTip_mm, 0.0))));
      const double x = std::clamp(1.0 - fromTip_mm / tip_mm, 0.0, 1.0);
      return Point{path.at(fromTip_mm), full_mm * std::sqrt(1.0 - x * x), isDash};
    };
    const int steps = static_cast<int>(std::ceil(length_mm / step_mm));
    for (int i = 0; i <= steps; ++i)
      line_.push_back(pointAt(length_mm * i / steps, i % (dashSteps + gapSteps) <= dashSteps));
    for (const Length contact : array.contactsFromTip)
      contacts_.push_back(pointAt(inMillimeters(contact), true));
  }
  band_.actor().SetVisibility(!line_.empty());
  outline_.actor().SetVisibility(!line_.empty());
}

void GhostArray::addOutline(const ViewFrame& view, double side)
{
  bool isDash = false;
  for (const Point& point : line_) {
    if (point.isDash && !isDash) outline_.begin(LineEdge::firm);
    isDash = point.isDash;
    if (!isDash) continue;
    outline_.add({edgeOf(point.at, point.radius_mm, side, view), palette_.ghost,
                  lineWidth_px * view.pixel_mm});
  }
}

void GhostArray::lookFrom(const ViewFrame& view)
{
  if (line_.empty()) return;
  band_.clear();
  outline_.clear();
  band_.begin(LineEdge::firm);
  for (const Point& point : line_)
    band_.add({point.at.place, withOpacity(palette_.ghost, bandOpacity), point.radius_mm});
  for (const double side : {-1.0, 1.0}) addOutline(view, side);
  for (const Point& contact : contacts_) {
    outline_.begin(LineEdge::firm);
    for (const double side : {-1.0, 1.0})
      outline_.add({edgeOf(contact.at, contact.radius_mm, side, view), palette_.ghost,
                    lineWidth_px * view.pixel_mm});
  }
  band_.build(view, -lift_mm);
  outline_.build(view, lift_mm);
}

}  // namespace perilymph::visualization
