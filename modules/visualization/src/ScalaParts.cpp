// SPDX-License-Identifier: BSD-3-Clause
#include "ScalaParts.h"

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "ForceColors.h"
#include "perilymph/anatomy/Surface.h"

namespace perilymph::visualization {
namespace {

constexpr double patchReach_mm = 0.45;  ///< Radius of a contact's color on the wall.
constexpr double shortestEdge_mm = 1.0;
constexpr double edgeOpacity = 0.9;
// A thin shell is most transparent where it faces the viewer and least where it turns away.
constexpr double facingOpacity = 0.07, turnedOpacity = 0.46;
constexpr double ambient = 0.42, diffuse = 0.58;
// The wall shines where it mirrors the light, as moist bone does: shape is seen where it faces the viewer, too.
constexpr double shine = 0.35, shineOpacity = 0.18, shininess = 12.0;
constexpr double keyLight[] = {-0.5, 0.75};  ///< To the right and up, for a light toward the
                                             ///< viewer.
constexpr double membraneOpacity = 0.42, tornOpacity = 0.85;

/// Blends a force's color over the shell's.
Rgba over(const Rgba& shell, const Rgba& force)
{
  const double cover = force[3] / 255.0;
  Rgba mixed = shell;
  for (std::size_t i = 0; i < 3; ++i)
    mixed[i] = static_cast<unsigned char>(shell[i] + cover * (force[i] - shell[i]));
  mixed[3] = std::max(shell[3], force[3]);
  return mixed;
}

std::vector<Triangle> mirroredIf(bool mirrors, const std::vector<Triangle>& triangles)
{
  std::vector<Triangle> result = triangles;
  if (mirrors)
    for (Triangle& corners : result) std::swap(corners[1], corners[2]);
  return result;
}

std::vector<Eigen::Vector3d> placesOf(const anatomy::Surface& surface, const PictureSpace& space)
{
  std::vector<Eigen::Vector3d> places;
  places.reserve(surface.points.size());
  for (const std::array<double, 3>& point : surface.points)
    places.push_back(space.place({point[0], point[1], point[2]}));
  return places;
}

void fill(Mesh& mesh, const std::vector<Eigen::Vector3d>& places,
          const std::vector<Eigen::Vector3d>& normals, const std::vector<Triangle>& triangles)
{
  mesh.shape(static_cast<int>(places.size()), triangles);
  for (std::size_t i = 0; i < places.size(); ++i) {
    mesh.point(static_cast<int>(i)) = places[i].cast<float>();
    mesh.normal(static_cast<int>(i)) = normals[i].cast<float>();
  }
  mesh.pointsChanged();
}

void addAll(SoftLines& lines, const std::vector<Polyline>& all, const Rgba& color,
            double halfWidth_mm)
{
  for (const Polyline& one : all) {
    lines.begin(LineEdge::firm);
    for (const Eigen::Vector3d& place : one) lines.add({place, color, halfWidth_mm});
  }
}

}  // namespace

ScalaParts::ScalaParts(const anatomy::ScalaTympani& scala, const PictureSpace& space,
                       const QualityTraits& traits, const SceneColors& palette)
    : traits_(traits), palette_(palette)
{
  plan(scala, space);
  planMembrane(scala, space);
  sortIntoBins();
}

void ScalaParts::plan(const anatomy::ScalaTympani& scala, const PictureSpace& space)
{
  const anatomy::Surface surface = anatomy::wallSurface(scala, traits_.wallTriangles);
  const std::vector<Triangle> triangles = mirroredIf(space.mirrors(), surface.triangles);
  places_ = placesOf(surface, space);
  const std::vector<Eigen::Vector3d> normals = pointNormals(places_, triangles);
  fill(wall_, places_, normals, triangles);
  normals_ = normals;
  shell_.assign(places_.size(), withOpacity(palette_.bone, facingOpacity));
  force_mN_mm_.assign(places_.size(), 0.0f);

  low_ = high_ = places_.front();
  for (const Eigen::Vector3d& place : places_) {
    low_ = low_.cwiseMin(place);
    high_ = high_.cwiseMax(place);
  }
  silhouette_.emplace(places_, normals, triangles);
  rims_ = silhouette_->rims();

  // Lit at the vertices once per view instead of at every pixel: saves a fifth of a frame on a CPU.
  vtkActor& farWall = wall_.actor();
  farWall.GetProperty()->LightingOff();
  farWall.ForceTranslucentOn();
  nearWall_ = wall_.anotherActor();
  nearWall_->ForceTranslucentOn();
  farWall.GetProperty()->FrontfaceCullingOn();
  nearWall_->GetProperty()->BackfaceCullingOn();
}

void ScalaParts::planMembrane(const anatomy::ScalaTympani& scala, const PictureSpace& space)
{
  const anatomy::Surface surface = anatomy::membraneSurface(scala, 1200);
  const std::vector<Triangle> triangles = mirroredIf(space.mirrors(), surface.triangles);
  const std::vector<Eigen::Vector3d> places = placesOf(surface, space);
  const std::vector<Eigen::Vector3d> normals = pointNormals(places, triangles);
  fill(membrane_, places, normals, triangles);
  membrane_.paint(withOpacity(palette_.membrane, membraneOpacity));
  membrane_.actor().GetProperty()->LightingOff();
  membraneRims_ = Silhouette(places, normals, triangles).rims();
  fill(torn_, places, normals, {});
  torn_.paint(withOpacity(palette_.rupture, tornOpacity));
  torn_.actor().GetProperty()->LightingOff();
  membraneTriangles_ = triangles;
  pieceAngle_ = scala.lastAngle().si() / static_cast<double>(triangles.size() / 2);
}

void ScalaParts::addFarWall(vtkRenderer& renderer) { renderer.AddActor(&wall_.actor()); }

void ScalaParts::addMembrane(vtkRenderer& renderer)
{
  renderer.AddActor(&membrane_.actor());
  renderer.AddActor(&torn_.actor());
  renderer.AddActor(&membraneEdges_.actor());
}

void ScalaParts::addNearWall(vtkRenderer& renderer)
{
  renderer.AddActor(nearWall_);
  renderer.AddActor(&edges_.actor());
}

void ScalaParts::setVisible(bool wall, bool membrane)
{
  wall_.actor().SetVisibility(wall);
  nearWall_->SetVisibility(wall);
  edges_.actor().SetVisibility(wall);
  membrane_.actor().SetVisibility(membrane);
  torn_.actor().SetVisibility(membrane);
  membraneEdges_.actor().SetVisibility(membrane);
}

void ScalaParts::tear(std::span<const std::array<double, 2>> ranges)
{
  if (std::equal(ranges.begin(), ranges.end(), ranges_.begin(), ranges_.end())) return;
  ranges_.assign(ranges.begin(), ranges.end());
  std::vector<Triangle> torn;
  for (std::size_t piece = 0; 2 * piece + 1 < membraneTriangles_.size(); ++piece) {
    const double middle = (static_cast<double>(piece) + 0.5) * pieceAngle_;
    const bool isTorn = std::any_of(ranges_.begin(), ranges_.end(), [&](const auto& range) {
      return middle > range[0] && middle < range[1];
    });
    if (!isTorn) continue;
    torn.push_back(membraneTriangles_[2 * piece]);
    torn.push_back(membraneTriangles_[2 * piece + 1]);
  }
  torn_.connect(torn);
}

void ScalaParts::light(const ViewFrame& view)
{
  const Eigen::Vector3d key =
      (view.back + keyLight[0] * view.right + keyLight[1] * view.up).normalized();
  const Eigen::Vector3d halfway = (key + view.back).normalized();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    // the visible side, inner or outer
    const double facing = normals_[i].dot(view.back);
    const double lit = facing < 0.0 ? -normals_[i].dot(key) : normals_[i].dot(key);
    const double light = ambient + diffuse * std::max(0.0, lit);
    const double mirrored = std::pow(std::abs(normals_[i].dot(halfway)), shininess);
    const double turn = 1.0 - std::abs(facing);
    Rgba color = withOpacity(palette_.bone,
                             facingOpacity + (turnedOpacity - facingOpacity) * turn * turn * turn +
                                 shineOpacity * mirrored);
    for (std::size_t k = 0; k < 3; ++k)
      color[k] = static_cast<unsigned char>(std::min(255.0, (light + shine * mirrored) * color[k]));
    shell_[i] = color;
    wall_.setColor(static_cast<int>(i), color);
  }
  for (const int index : touched_) paintTouched(index);
  wall_.colorsChanged();
}

void ScalaParts::paintTouched(int index)
{
  const std::size_t i = static_cast<std::size_t>(index);
  wall_.setColor(index, over(shell_[i], forceColor(force_mN_mm_[i], palette_.scheme)));
}

void ScalaParts::lookFrom(const ViewFrame& view)
{
  if (view.back != litFrom_.back || view.up != litFrom_.up) {
    light(view);
    if (traits_.hasSilhouettes) silhouettes_ = silhouette_->lines(view.back, shortestEdge_mm);
    litFrom_ = view;
  }
  edges_.clear();
  const Rgba color = withOpacity(palette_.bone, edgeOpacity);
  addAll(edges_, silhouettes_, color, 0.8 * view.pixel_mm);
  addAll(edges_, rims_, color, 0.8 * view.pixel_mm);
  edges_.build(view, 0.02);

  membraneEdges_.clear();
  addAll(membraneEdges_, membraneRims_, withOpacity(palette_.membrane, 0.55), 0.5 * view.pixel_mm);
  membraneEdges_.build(view, 0.01);
}

long ScalaParts::bin(int x, int y, int z) const { return x + 4096L * (y + 4096L * z); }

void ScalaParts::sortIntoBins()
{
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Eigen::Vector3d cell = (places_[i] - low_) / patchReach_mm;
    bins_[bin(static_cast<int>(cell.x()), static_cast<int>(cell.y()), static_cast<int>(cell.z()))]
        .push_back(static_cast<int>(i));
  }
}

void ScalaParts::color(const ContactField& field)
{
  if (!field.isTouching() && touched_.empty()) return;
  for (const int index : touched_) {
    force_mN_mm_[static_cast<std::size_t>(index)] = 0.0f;
    wall_.setColor(index, shell_[static_cast<std::size_t>(index)]);
  }
  touched_.clear();

  // The bell's integral along a straight contact is 16/15 of its reach: with this scale the center
  // of a long uniform contact shows its force per length.
  const double scale = ContactField::spacing_mm * 15.0 / (16.0 * patchReach_mm);
  for (const ContactStation& station : field.stations()) {
    if (station.force_mN_mm <= 0.0) continue;
    const Eigen::Vector3d cell = (station.wall - low_) / patchReach_mm;
    const int x = static_cast<int>(std::floor(cell.x()));
    const int y = static_cast<int>(std::floor(cell.y()));
    const int z = static_cast<int>(std::floor(cell.z()));
    for (int around = 0; around < 27; ++around) {
      const auto found =
          bins_.find(bin(x + around % 3 - 1, y + around / 3 % 3 - 1, z + around / 9 - 1));
      if (found == bins_.end()) continue;
      for (const int index : found->second) {
        const std::size_t i = static_cast<std::size_t>(index);
        const double weight = bell((places_[i] - station.wall).norm(), patchReach_mm);
        if (weight <= 0.0) continue;
        if (force_mN_mm_[i] == 0.0f) touched_.push_back(index);
        force_mN_mm_[i] += static_cast<float>(weight * scale * station.force_mN_mm);
      }
    }
  }
  for (const int index : touched_) paintTouched(index);
  wall_.colorsChanged();
}

}  // namespace perilymph::visualization
