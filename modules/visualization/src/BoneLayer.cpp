// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/visualization/BoneLayer.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "BoneParts.h"
#include "LandmarkParts.h"
#include "PictureSpace.h"

namespace perilymph::visualization {
namespace {

constexpr double shortest_per_mm = 0.35;  // of a pixel's size: a cut that faces the viewer (choice)

// Of the line, where its handle is at least: nearer to the opening it would be hard to turn (choice).
constexpr double shortestHandle = 0.25;

}  // namespace

CutPlane moved(const CutPlane& cut, double length, const BoneModel& bone)
{
  const double height = cut.removed.dot(cut.origin - bone.center);
  const double now = std::clamp(height + length, -bone.radius, bone.radius);
  return {cut.origin + (now - height) * cut.removed, cut.removed};
}

struct BoneLayer::Content {
  Content(vtkRenderer& owner, const Eigen::Affine3d& toPicture, const SceneStyle& style)
      : renderer(owner),
        picture(toPicture),
        palette(sceneColorsOf(style.scheme)),
        landmarkParts(palette)
  {
    landmarkParts.setVisible(false);
  }
  ~Content()
  {
    if (boneParts) boneParts->removeFrom(renderer);
  }

  vtkRenderer& renderer;
  Eigen::Affine3d picture;
  const SceneColors& palette;
  LandmarkParts landmarkParts;
  std::shared_ptr<const BoneModel> bone;
  std::unique_ptr<BoneParts> boneParts;
  bool isVisible = false, isMoving = false, isFine = false, isChanged = true;
  ViewFrame view{.pixel_mm = 0.0};
};

BoneLayer::BoneLayer(vtkRenderer& renderer, const Eigen::Affine3d& picture, const SceneStyle& style)
    : content_(std::make_unique<Content>(renderer, picture, style))
{
}

BoneLayer::~BoneLayer() = default;

void BoneLayer::setBone(std::shared_ptr<const BoneModel> bone)
{
  Content& c = *content_;
  if (bone == c.bone) return;
  if (c.boneParts) c.boneParts->removeFrom(c.renderer);
  c.boneParts.reset();
  c.bone = std::move(bone);
  c.isChanged = true;
  if (!c.bone) return;
  c.boneParts = std::make_unique<BoneParts>(c.bone, c.picture, c.palette);
  c.boneParts->setCut(c.bone->cut);
  c.boneParts->setMoving(c.isMoving);
  c.boneParts->setVisible(c.isVisible);
  c.boneParts->addTo(c.renderer);
}

const std::shared_ptr<const BoneModel>& BoneLayer::bone() const { return content_->bone; }

void BoneLayer::setLandmarks(SceneLandmarks landmarks)
{
  Content& c = *content_;
  LandmarkPlaces places;
  const auto place = [&c](const Eigen::Vector3d& point) -> Eigen::Vector3d {
    return c.picture * point;
  };
  const auto line = [&place](const std::array<Eigen::Vector3d, 2>& ends) {
    return std::array<Eigen::Vector3d, 2>{place(ends[0]), place(ends[1])};
  };
  if (landmarks.roundWindow) places.roundWindow = place(*landmarks.roundWindow);
  if (landmarks.axis) places.axis = line(*landmarks.axis);
  if (landmarks.approach) places.approach = line(*landmarks.approach);
  for (const Eigen::Vector3d& contact : landmarks.contacts)
    places.contacts.push_back(place(contact));
  for (const auto& [name, other] : landmarks.others) places.others.emplace_back(name, place(other));
  for (MarkedCourse course : landmarks.courses) {
    for (Eigen::Vector3d& point : course.points) point = place(point);
    if (course.distance) course.distance = line(*course.distance);
    places.courses.push_back(std::move(course));
  }
  c.landmarkParts.place(std::move(places));
  c.isChanged = true;
}

void BoneLayer::setVisible(bool isVisible)
{
  Content& c = *content_;
  c.isVisible = isVisible;
  c.isChanged = true;
  c.landmarkParts.setVisible(isVisible);
  if (c.boneParts) c.boneParts->setVisible(isVisible);
}

bool BoneLayer::isVisible() const { return content_->isVisible; }

void BoneLayer::keepFine() { content_->isFine = true; }

void BoneLayer::setMoving(bool isMoving)
{
  Content& c = *content_;
  if (c.isMoving == isMoving || c.isFine) return;
  c.isMoving = isMoving;
  c.isChanged = true;
  if (c.boneParts) c.boneParts->setMoving(isMoving);
}

bool BoneLayer::isMoving() const { return content_->isMoving; }

std::optional<CutPlane> BoneLayer::cut() const
{
  return content_->boneParts ? content_->boneParts->cut() : std::nullopt;
}

void BoneLayer::moveCut(double by_mm)
{
  if (!cut()) return;
  content_->boneParts->setCut(moved(*cut(), 1e-3 * by_mm, *content_->bone));
  content_->isChanged = true;
}

void BoneLayer::faceCut()
{
  Content& c = *content_;
  if (!cut()) return;
  const Eigen::Vector3d removed = (c.picture.linear().inverse() * c.view.back).normalized();
  c.boneParts->setCut(CutPlane{c.bone->center, removed});
  c.isChanged = true;
}

std::optional<CutHandle> BoneLayer::handle() const
{
  const Content& c = *content_;
  const auto plane = cut();
  if (!plane || !c.isVisible || c.view.pixel_mm <= 0.0) return std::nullopt;
  const Eigen::Vector3d removed = (c.picture.linear() * plane->removed).normalized();
  const Eigen::Vector3d origin = c.picture * plane->origin, center = c.picture * c.bone->center;
  const double scale = 1e3, height = removed.dot(origin - center);
  const double half =
      std::sqrt(std::max(0.0, std::pow(scale * c.bone->radius, 2.0) - height * height));
  // the right of the rim, where views have no read-outs
  const Eigen::Vector3d wanted = c.view.right - 0.1 * c.view.up;
  Eigen::Vector3d along = wanted - wanted.dot(removed) * removed;
  along = along.norm() > 1e-6 ? Eigen::Vector3d(along.normalized()) : removed.unitOrthogonal();
  const Eigen::Vector3d rim = center + height * removed + half * along;
  CutHandle handle;
  handle.at_px = placeIn(c.renderer, rim);
  handle.per_mm = placeIn(c.renderer, rim + removed) - handle.at_px;
  const double full = (placeIn(c.renderer, rim + c.view.up) - handle.at_px).norm();
  // a cut that faces the viewer follows up and down
  if (handle.per_mm.norm() < shortest_per_mm * full) handle.per_mm = {0.0, -full};
  return handle;
}

std::optional<ApproachHandle> BoneLayer::approachHandle(double margin_px) const
{
  const Content& c = *content_;
  const auto& line = c.landmarkParts.places().approach;
  if (!line || !c.isVisible || c.view.pixel_mm <= 0.0) return std::nullopt;
  const auto& [outer, inner] = *line;
  const Eigen::Vector2d from = placeIn(c.renderer, inner), to = placeIn(c.renderer, outer);
  const int* const size = c.renderer.GetSize();
  double part = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = margin_px, high = std::max(low, size[axis] - margin_px);
    const double by = to[axis] - from[axis];
    if (by == 0.0 || (to[axis] >= low && to[axis] <= high)) continue;
    part = std::min(part, ((by > 0.0 ? high : low) - from[axis]) / by);
  }
  part = std::max(part, shortestHandle);
  return ApproachHandle{from + part * (to - from), part * c.view.back.dot(outer - inner)};
}

std::optional<Eigen::Vector3d> BoneLayer::approachTo(const Eigen::Vector2d& place_px,
                                                     double toViewer_mm) const
{
  const Content& c = *content_;
  const auto& line = c.landmarkParts.places().approach;
  if (!line || c.view.pixel_mm <= 0.0) return std::nullopt;
  const Eigen::Vector3d& inner = (*line)[1];
  // the projection is parallel
  const Eigen::Vector2d from = placeIn(c.renderer, inner);
  const double perMm_px = (placeIn(c.renderer, inner + c.view.right) - from).norm();
  const Eigen::Vector2d by_mm = (place_px - from) / std::max(perMm_px, 1e-9);
  const Eigen::Vector3d to =
      by_mm.x() * c.view.right - by_mm.y() * c.view.up + toViewer_mm * c.view.back;
  if (to.norm() < 1e-6) return std::nullopt;
  return (c.picture.linear().inverse() * to).normalized();
}

std::vector<SceneAnchor> BoneLayer::anchors() const
{
  return content_->landmarkParts.anchorsIn(content_->renderer);
}

std::size_t BoneLayer::triangles() const
{
  return content_->boneParts && content_->isVisible ? content_->boneParts->triangles() : 0;
}

void BoneLayer::addLines() { content_->landmarkParts.addTo(content_->renderer); }

void BoneLayer::lookFrom(const ViewFrame& view)
{
  Content& c = *content_;
  if (!c.isVisible || (!c.isChanged && view == c.view)) return;
  c.view = view;
  c.isChanged = false;
  if (c.boneParts) c.boneParts->lookFrom(view);
  c.landmarkParts.lookFrom(view);
}

}  // namespace perilymph::visualization
