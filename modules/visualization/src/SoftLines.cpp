// SPDX-License-Identifier: BSD-3-Clause
#include "SoftLines.h"

#include <vtkActor.h>
#include <vtkProperty.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace perilymph::visualization {
namespace {

/// Points across a strip: transparent, opaque, opaque, transparent.
constexpr int across = 4;

/// Unit vector across the line in the picture plane; that of the previous point where the line
/// points toward the viewer.
Eigen::Vector3d sideways(const Eigen::Vector3d& along, const ViewFrame& view,
                         const Eigen::Vector3d& before)
{
  const Eigen::Vector3d side = along.cross(view.back);
  const double length = side.norm();
  return length > 1e-9 ? Eigen::Vector3d(side / length) : before;
}

}  // namespace

SoftLines::SoftLines()
{
  vtkActor& actor = mesh_.actor();
  actor.GetProperty()->LightingOff();
  actor.ForceTranslucentOn();
  actor.UseBoundsOff();
}

void SoftLines::clear()
{
  points_.clear();
  lines_.clear();
}

void SoftLines::begin(LineEdge edge) { lines_.push_back({points_.size(), edge}); }

std::size_t SoftLines::lineEnd(std::size_t line) const
{
  return line + 1 < lines_.size() ? lines_[line + 1].first : points_.size();
}

void SoftLines::build(const ViewFrame& view, double toward_mm)
{
  connectStrips();
  const Eigen::Vector3d lift = toward_mm * view.back;
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const std::size_t first = lines_[line].first;
    const std::size_t end = lineEnd(line);
    Eigen::Vector3d side = view.up;
    for (std::size_t i = first; i < end; ++i) {
      const LinePoint& point = points_[i];
      const Eigen::Vector3d along =
          points_[std::min(i + 1, end - 1)].place - points_[i > first ? i - 1 : first].place;
      side = sideways(along, view, side);
      const bool isFirm = lines_[line].edge == LineEdge::firm;
      const double fade = isFirm ? 0.5 * view.pixel_mm : 0.5 * point.halfWidth_mm;
      const double middle = isFirm ? point.halfWidth_mm : 0.5 * point.halfWidth_mm;
      const double offsets[across] = {-middle - fade, std::min(0.0, fade - middle),
                                      std::max(0.0, middle - fade), middle + fade};
      for (int k = 0; k < across; ++k) {
        const int index = across * static_cast<int>(i) + k;
        mesh_.point(index) = (point.place + lift + offsets[k] * side).cast<float>();
        mesh_.normal(index) = view.back.cast<float>();
        Rgba color = point.color;
        if (k == 0 || k == across - 1) color[3] = 0;
        mesh_.setColor(index, color);
      }
    }
  }
  mesh_.pointsChanged();
  mesh_.colorsChanged();
}

void SoftLines::connectStrips()
{
  starts_.clear();
  for (const Line& line : lines_) starts_.push_back(line.first);
  starts_.push_back(points_.size());
  if (starts_ == builtStarts_) return;

  builtStarts_ = starts_;
  triangles_.clear();
  for (std::size_t line = 0; line < lines_.size(); ++line)
    for (std::size_t i = lines_[line].first; i + 1 < lineEnd(line); ++i)
      for (int k = 0; k + 1 < across; ++k) {
        const int a = across * static_cast<int>(i) + k;
        const int b = a + across;
        triangles_.push_back({a, a + 1, b});
        triangles_.push_back({a + 1, b + 1, b});
      }
  mesh_.shape(across * static_cast<int>(points_.size()), triangles_);
}

}  // namespace perilymph::visualization
