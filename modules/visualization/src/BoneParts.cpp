// SPDX-License-Identifier: BSD-3-Clause
#include "BoneParts.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>

#include "Silhouette.h"

namespace perilymph::visualization {
namespace {

constexpr double ambient = 0.34, diffuse = 0.66;
constexpr double keyLight[] = {-0.5,
                               0.75};  ///< To the right and up, for a light toward the viewer.
constexpr double dark_mm = 7.0, darkest = 0.35;  ///< Behind the cut, where depth darkens no more.
constexpr int facePixels = 512, movingFacePixels = 160;
constexpr double darkestFace = 0.3;   ///< Fraction of the color where the CT is just bone.
constexpr double fullContrast = 0.6;  ///< Above the level, where it is as bright as the bone.

/// Two directions at right angles to a unit vector and to each other.
std::array<Eigen::Vector3d, 2> across(const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d one = direction.unitOrthogonal();
  return {one, direction.cross(one)};
}

}  // namespace

BoneParts::BoneParts(std::shared_ptr<const BoneModel> bone, const Eigen::Affine3d& picture,
                     const SceneColors& palette)
    : bone_(std::move(bone)), picture_(picture), palette_(palette)
{
  plan(fine_, bone_->fine);
  plan(coarse_, bone_->coarse);

  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(4);
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  for (const auto& [x, y] : {std::array{0.F, 0.F}, {1.F, 0.F}, {1.F, 1.F}, {0.F, 1.F}})
    places->InsertNextTuple2(x, y);
  vtkNew<vtkCellArray> square;
  square->InsertNextCell({0, 1, 2, 3});
  face_->SetPoints(points);
  face_->SetPolys(square);
  face_->GetPointData()->SetTCoords(places);
  texture_->SetInputData(picturePixels_);
  texture_->InterpolateOn();
  texture_->SetColorModeToDirectScalars();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(face_);
  faceActor_->SetMapper(mapper);
  faceActor_->SetTexture(texture_);
  faceActor_->GetProperty()->LightingOff();
  faceActor_->ForceOpaqueOn();  // what is no bone is not drawn, also not into the depth
  showParts();
}

BoneParts::~BoneParts() = default;

void BoneParts::plan(Level& level, const anatomy::Surface& surface)
{
  const bool isMirrored = picture_.linear().determinant() < 0.0;
  level.places.reserve(surface.points.size());
  for (const auto& point : surface.points)
    level.places.push_back(picture_ * Eigen::Vector3d(point[0], point[1], point[2]));
  std::vector<Triangle> triangles = surface.triangles;
  if (isMirrored)
    for (Triangle& corners : triangles) std::swap(corners[1], corners[2]);
  level.triangles = triangles.size();
  level.normals = pointNormals(level.places, triangles);
  level.mesh.shape(static_cast<int>(level.places.size()), triangles);
  for (std::size_t i = 0; i < level.places.size(); ++i) {
    level.mesh.point(static_cast<int>(i)) = level.places[i].cast<float>();
    level.mesh.normal(static_cast<int>(i)) = level.normals[i].cast<float>();
  }
  level.mesh.pointsChanged();
  vtkProperty& look = *level.mesh.actor().GetProperty();
  look.LightingOff();
  look.BackfaceCullingOn();  // the inside of the bone is behind the face of the cut
  level.mesh.actor().ForceOpaqueOn();
}

void BoneParts::addTo(vtkRenderer& renderer)
{
  renderer.AddActor(&fine_.mesh.actor());
  renderer.AddActor(&coarse_.mesh.actor());
  renderer.AddActor(faceActor_);
}

void BoneParts::removeFrom(vtkRenderer& renderer)
{
  renderer.RemoveActor(&fine_.mesh.actor());
  renderer.RemoveActor(&coarse_.mesh.actor());
  renderer.RemoveActor(faceActor_);
}

void BoneParts::setVisible(bool isVisible)
{
  isVisible_ = isVisible;
  showParts();
}

void BoneParts::setMoving(bool isMoving)
{
  isMoving_ = isMoving;
  showParts();
}

void BoneParts::showParts()
{
  fine_.mesh.actor().SetVisibility(isVisible_ && !isMoving_ && fine_.triangles > 0);
  coarse_.mesh.actor().SetVisibility(isVisible_ && isMoving_ && coarse_.triangles > 0);
  faceActor_->SetVisibility(isVisible_ && cut_.has_value());
}

void BoneParts::setCut(const std::optional<CutPlane>& cut)
{
  cut_ = cut;
  facePixels_ = 0;
  fine_.isLit = coarse_.isLit = false;
  for (Level* level : {&fine_, &coarse_})
    level->mesh.actor().GetMapper()->RemoveAllClippingPlanes();
  if (cut_) {
    const Eigen::Vector3d origin = picture_ * cut_->origin;
    const Eigen::Vector3d kept = -(picture_.linear() * cut_->removed).normalized();
    plane_->SetOrigin(origin.data());
    plane_->SetNormal(kept.data());
    for (Level* level : {&fine_, &coarse_})
      level->mesh.actor().GetMapper()->AddClippingPlane(plane_);
  }
  showParts();
}

void BoneParts::lookFrom(const ViewFrame& view)
{
  if (!isVisible_) return;
  if (view.back != view_.back || view.up != view_.up) fine_.isLit = coarse_.isLit = false;
  view_ = view;
  if (!shown().isLit) light(shown());
  if (cut_ && facePixels_ < (isMoving_ ? movingFacePixels : facePixels)) paintFace();
}

void BoneParts::light(Level& level)
{
  const Eigen::Vector3d key =
      (view_.back + keyLight[0] * view_.right + keyLight[1] * view_.up).normalized();
  Eigen::Vector3d kept = Eigen::Vector3d::Zero(), origin = kept;
  if (cut_) {
    kept = -(picture_.linear() * cut_->removed).normalized();
    origin = picture_ * cut_->origin;
  }
  for (std::size_t i = 0; i < level.places.size(); ++i) {
    const double depth_mm = kept.dot(level.places[i] - origin);
    const double depth = std::clamp(depth_mm / dark_mm, 0.0, 1.0);
    const double brightness = (ambient + diffuse * std::max(0.0, level.normals[i].dot(key))) *
                              (1.0 - (1.0 - darkest) * depth);
    Rgba color = palette_.solidBone;
    for (std::size_t k = 0; k < 3; ++k)
      color[k] = static_cast<unsigned char>(brightness * color[k]);
    color[3] = 255;
    level.mesh.setColor(static_cast<int>(i), color);
  }
  level.mesh.colorsChanged();
  level.isLit = true;
}

void BoneParts::paintFace()
{
  facePixels_ = isMoving_ ? movingFacePixels : facePixels;
  // the disk in which the plane cuts the ball
  const double height = cut_->removed.dot(cut_->origin - bone_->center);
  const Eigen::Vector3d center = bone_->center + height * cut_->removed;
  const double half = std::sqrt(std::max(0.0, bone_->radius * bone_->radius - height * height));
  const auto [one, other] = across(cut_->removed);
  const std::array<std::array<double, 2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector3d place =
        picture_ * (center + half * (corners[k][0] * one + corners[k][1] * other));
    face_->GetPoints()->SetPoint(static_cast<vtkIdType>(k), place.data());
  }
  face_->GetPoints()->Modified();
  face_->Modified();

  picturePixels_->SetDimensions(facePixels_, facePixels_, 1);
  picturePixels_->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(picturePixels_->GetScalarPointer());
  for (int y = 0; y < facePixels_; ++y)
    for (int x = 0; x < facePixels_; ++x, pixel += 4) {
      const double right = (2.0 * x + 1.0) / facePixels_ - 1.0;
      const double up = (2.0 * y + 1.0) / facePixels_ - 1.0;
      std::fill(pixel, pixel + 4, static_cast<unsigned char>(0));
      if (right * right + up * up > 1.0) continue;
      const auto value = bone_->intensity(center + half * (right * one + up * other));
      const double over = value ? (*value - bone_->level) / bone_->contrast : -1.0;
      const double gray =
          darkestFace + (1.0 - darkestFace) * std::clamp(over / fullContrast, 0.0, 1.0);
      for (std::size_t k = 0; k < 3; ++k)
        pixel[k] = static_cast<unsigned char>(gray * palette_.solidBone[k]);
      pixel[3] = over >= 0.0 ? 255 : 0;
    }
  picturePixels_->Modified();
}

}  // namespace perilymph::visualization
