// SPDX-License-Identifier: BSD-3-Clause
#include "LandmarkParts.h"

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "perilymph/figures/FixedInks.h"

namespace perilymph::visualization {
namespace {

constexpr double ring_mm = 0.6;  // half of the round window's mean height, 1.2 mm or less (choice)
constexpr int ringPoints = 48;
constexpr double line_px = 1.3;     // half the width
constexpr double toward_mm = 45.0;  // before bone and cochlea, behind the near plane of the camera
constexpr double arrow_mm = 1.0;
constexpr double dot_mm = 0.15;  // half of a marked point's cross (choice)
// Part of the line from the opening to where its label points: near it, which every view of the ear shows.
constexpr double approachLabel = 0.12;

}  // namespace

Eigen::Vector2d placeIn(vtkRenderer& renderer, const Eigen::Vector3d& point)
{
  renderer.SetWorldPoint(point.x(), point.y(), point.z(), 1.0);
  renderer.WorldToDisplay();
  const double* at = renderer.GetDisplayPoint();
  return {at[0], renderer.GetSize()[1] - at[1]};
}

LandmarkParts::LandmarkParts(const SceneColors& palette) : palette_(palette) {}

void LandmarkParts::addTo(vtkRenderer& renderer) { renderer.AddActor(&lines_.actor()); }

void LandmarkParts::setVisible(bool isVisible)
{
  isVisible_ = isVisible;
  lines_.actor().SetVisibility(isVisible);
}

void LandmarkParts::lookFrom(const ViewFrame& view)
{
  if (!isVisible_) return;
  lines_.clear();
  const double half_mm = line_px * view.pixel_mm;
  const Rgba axisColor = withOpacity(palette_.frictionArrow, 0.95);
  const Rgba approachColor = withOpacity(palette_.arrow, 0.95);
  const auto draw = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Rgba& color) {
    lines_.begin(LineEdge::firm);
    lines_.add({from, color, half_mm});
    lines_.add({to, color, half_mm});
  };
  if (places_.axis) draw((*places_.axis)[0], (*places_.axis)[1], axisColor);
  if (places_.approach) {
    const auto& [from, to] = *places_.approach;
    draw(from, to, approachColor);
    // an arrow in the picture plane, unless the line points at the viewer
    const Eigen::Vector3d back = (from - to).normalized();
    const Eigen::Vector3d aside = view.back.cross(back);
    if (aside.norm() > 0.1)
      for (const double side : {-0.5, 0.5})
        draw(to, to + arrow_mm * (back + side * aside.normalized()), approachColor);
  }
  const Rgba courseColor = rgbaOf(figures::onBone::markup);
  for (const MarkedCourse& course : places_.courses) {
    for (std::size_t k = 0; k + 1 < course.points.size(); ++k)
      draw(course.points[k], course.points[k + 1], courseColor);
    for (const Eigen::Vector3d& point : course.points) {  // a small cross at each
      draw(point - dot_mm * view.right, point + dot_mm * view.right, courseColor);
      draw(point - dot_mm * view.up, point + dot_mm * view.up, courseColor);
    }
    if (course.distance) draw((*course.distance)[0], (*course.distance)[1], courseColor);
  }
  if (places_.roundWindow) {
    lines_.begin(LineEdge::firm);
    for (int k = 0; k <= ringPoints; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / ringPoints;
      lines_.add({*places_.roundWindow +
                      ring_mm * (std::cos(angle) * view.right + std::sin(angle) * view.up),
                  approachColor, half_mm});
    }
  }
  lines_.build(view, toward_mm);
}

std::vector<SceneAnchor> LandmarkParts::anchorsIn(vtkRenderer& renderer) const
{
  std::vector<SceneAnchor> anchors;
  if (!isVisible_) return anchors;
  using Kind = SceneAnchor::Kind;
  if (places_.roundWindow)
    anchors.push_back({Kind::roundWindow, 0, {}, placeIn(renderer, *places_.roundWindow)});
  if (places_.axis)
    anchors.push_back({Kind::basalTurnAxis, 0, {}, placeIn(renderer, (*places_.axis)[1])});
  if (places_.approach) {
    const auto& [from, to] = *places_.approach;
    anchors.push_back({Kind::approach, 0, {}, placeIn(renderer, to + approachLabel * (from - to))});
  }
  for (std::size_t k = 0; k < places_.contacts.size(); ++k)
    anchors.push_back(
        {Kind::contact, static_cast<int>(k) + 1, {}, placeIn(renderer, places_.contacts[k])});
  for (const auto& [name, place] : places_.others)
    anchors.push_back({Kind::other, 0, name, placeIn(renderer, place)});
  for (const MarkedCourse& course : places_.courses)
    if (!course.points.empty())
      anchors.push_back(
          {Kind::other, 0, course.name,
           placeIn(renderer, course.distance ? (*course.distance)[0] : course.points.front())});
  return anchors;
}

}  // namespace perilymph::visualization
