// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayParts.h"

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace perilymph::visualization {
namespace {

constexpr int sides = 24;  ///< Sides of tube, ribs and stylet.
constexpr double ringSpacing_mm = 0.12;
constexpr int capRings = 6;
constexpr double leadStub_mm = 1.4;
constexpr double siliconeOpacity = 0.88;  ///< So that the stylet is visible.

// Contacts: half-bands on the inner side, slightly above the silicone, with a bright rim.
constexpr double contactLift_mm = 0.012;
constexpr double contactHalfAngle = 0.5 * pi;
constexpr int contactAcross = 14, contactAlong = 6;

constexpr double ribHalfLength_mm = 0.17;
constexpr double ribHeight_mm = 0.16;
constexpr double styletRadius_mm = 0.06;  ///< As the platinum wire of the published array.
constexpr double styletSpare_mm = 6.0;    ///< Length protruding behind the tweezers.

constexpr double shadowWidth_mm = 0.16;
constexpr double outlineLift_mm = 1.2;  ///< Above the array, below the arrows.

/// Triangles between `count` rings of `around` points; rings are closed or open.
std::vector<Triangle> ringTriangles(int count, int around, bool isClosed, int firstPoint = 0)
{
  std::vector<Triangle> triangles;
  const int steps = isClosed ? around : around - 1;
  for (int i = 0; i + 1 < count; ++i)
    for (int k = 0; k < steps; ++k) {
      const int a = firstPoint + i * around + k;
      const int b = firstPoint + i * around + (k + 1) % around;
      triangles.push_back({a, b, a + around});
      triangles.push_back({b, b + around, a + around});
    }
  return triangles;
}

}  // namespace

ArrayParts::ArrayParts(const electrode::ArrayDesign& array, const SceneColors& palette)
    : array_(array), palette_(palette), tweezers_(inMillimeters(array.length), palette)
{
  if (array_.diameter.fromTip.empty() || array_.length <= millimeters(0)) {
    // No array: an empty scene without points.
    array_.length = millimeters(0);
    return;
  }
  tipRadius_mm_ = 0.5 * inMillimeters(array_.diameter.at(millimeters(0)));
  planTube();
  planContacts();
  planRibs();
  planStylet();
}

double ArrayParts::radius_mm(double fromTip_mm) const
{
  const double full = 0.5 * inMillimeters(array_.diameter.at(millimeters(fromTip_mm)));
  if (fromTip_mm >= tipRadius_mm_) return full;
  const double x = 1.0 - std::max(0.0, fromTip_mm) / tipRadius_mm_;
  return full * std::sqrt(std::max(0.0, 1.0 - x * x));
}

void ArrayParts::planTube()
{
  for (int i = 0; i < capRings; ++i) {
    const double angle = 0.5 * pi * i / capRings;  // 0 at the tip
    const double fromTip_mm = tipRadius_mm_ * (1.0 - std::cos(angle));
    tubeRings_.push_back({fromTip_mm, std::max(1e-4, radius_mm(fromTip_mm)), std::cos(angle)});
  }
  const double length_mm = inMillimeters(array_.length);
  const int count = static_cast<int>(std::ceil((length_mm - tipRadius_mm_) / ringSpacing_mm));
  for (int i = 0; i <= count; ++i) {
    const double fromTip_mm = tipRadius_mm_ + (length_mm - tipRadius_mm_) * i / count;
    tubeRings_.push_back({fromTip_mm, radius_mm(fromTip_mm), 0.0});
  }
  // behind the tweezers the lead continues a short distance and ends flat
  tubeRings_.push_back({length_mm + leadStub_mm, radius_mm(length_mm), 0.0});
  tubeRings_.push_back({length_mm + leadStub_mm, 1e-4, -1.0});
  const int rings = static_cast<int>(tubeRings_.size());
  tube_.shape(rings * sides, ringTriangles(rings, sides, true));
  tube_.paint(withOpacity(palette_.silicone, siliconeOpacity));
  vtkActor& actor = tube_.actor();
  actor.GetProperty()->SetSpecular(0.35);
  actor.GetProperty()->SetSpecularPower(30.0);
  actor.GetProperty()->SetAmbient(0.35);
  actor.GetProperty()->SetDiffuse(0.65);
  actor.GetProperty()->BackfaceCullingOn();
  // Blended over the stylet drawn before it, but hiding what is drawn later behind it.
  actor.ForceOpaqueOn();
}

void ArrayParts::planContacts()
{
  std::vector<Triangle> triangles;
  int points = 0;
  for (std::size_t i = 0; i < array_.contactsFromTip.size(); ++i) {
    const std::vector<Triangle> one = ringTriangles(contactAlong, contactAcross, false, points);
    triangles.insert(triangles.end(), one.begin(), one.end());
    points += contactAlong * contactAcross;
  }
  contacts_.shape(points, triangles);
  int index = 0;
  for (std::size_t i = 0; i < array_.contactsFromTip.size(); ++i)
    for (int a = 0; a < contactAlong; ++a)
      for (int c = 0; c < contactAcross; ++c, ++index) {
        const bool isRim = a == 0 || a == contactAlong - 1 || c == 0 || c == contactAcross - 1;
        contacts_.setColor(index, isRim ? palette_.platinumRim : palette_.platinum);
      }
  contacts_.colorsChanged();
  contacts_.actor().GetProperty()->SetSpecular(0.4);
  contacts_.actor().GetProperty()->SetSpecularPower(20.0);
}

void ArrayParts::planRibs()
{
  // A rib is a collar with a rounded profile.
  constexpr int profile = 7;
  std::vector<Triangle> triangles;
  for (const Length rib : array_.ribsFromTip) {
    const int first = static_cast<int>(ribRings_.size()) * sides;
    for (int i = 0; i < profile; ++i) {
      const double angle = pi * i / (profile - 1);
      const double fromTip_mm = inMillimeters(rib) - ribHalfLength_mm * std::cos(angle);
      ribRings_.push_back({fromTip_mm,
                           radius_mm(fromTip_mm) - 0.02 + ribHeight_mm * std::sin(angle),
                           std::cos(angle)});
    }
    const std::vector<Triangle> one = ringTriangles(profile, sides, true, first);
    triangles.insert(triangles.end(), one.begin(), one.end());
  }
  ribs_.shape(static_cast<int>(ribRings_.size()) * sides, triangles);
  ribs_.paint(palette_.rib);
  ribs_.actor().GetProperty()->SetSpecular(0.2);
}

void ArrayParts::planStylet()
{
  if (!array_.hasStylet) return;
  const double reach_mm = inMillimeters(array_.length - array_.stylet.fromTip) + styletSpare_mm;
  const int count = static_cast<int>(std::ceil(reach_mm / (2.0 * ringSpacing_mm)));
  // Positions are relative to the stylet's tip here; show() moves them.
  styletRings_.push_back({0.0, 1e-4, 1.0});
  for (int i = 0; i <= count; ++i)
    styletRings_.push_back({0.05 + reach_mm * i / count, styletRadius_mm, 0.0});
  const int rings = static_cast<int>(styletRings_.size());
  stylet_.shape(rings * sides, ringTriangles(rings, sides, true));
  stylet_.paint(palette_.steel);
  stylet_.actor().GetProperty()->SetSpecular(0.7);
  stylet_.actor().GetProperty()->SetSpecularPower(40.0);
}

void ArrayParts::addSolid(vtkRenderer& renderer)
{
  renderer.AddActor(&stylet_.actor());
  for (vtkActor* actor : tweezers_.actors()) renderer.AddActor(actor);
  renderer.AddActor(&contacts_.actor());
  renderer.AddActor(&ribs_.actor());
  renderer.AddActor(&tube_.actor());
}

void ArrayParts::addShadow(vtkRenderer& renderer) { renderer.AddActor(&shadow_.actor()); }
void ArrayParts::addOutline(vtkRenderer& renderer) { renderer.AddActor(&outline_.actor()); }

void ArrayParts::setVisible(bool array, bool styletAndTweezers)
{
  array = array && array_.length > millimeters(0);
  for (vtkActor* actor :
       {&tube_.actor(), &contacts_.actor(), &ribs_.actor(), &shadow_.actor(), &outline_.actor()})
    actor->SetVisibility(array);
  stylet_.actor().SetVisibility(array && styletAndTweezers && array_.hasStylet);
  for (vtkActor* actor : tweezers_.actors()) actor->SetVisibility(array && styletAndTweezers);
}

void ArrayParts::writeRings(Mesh& mesh, const std::vector<Ring>& rings, const ArrayPath& path)
{
  int index = 0;
  for (const Ring& ring : rings) {
    const PathPoint center = path.at(ring.fromTip_mm);
    const double outward = std::sqrt(std::max(0.0, 1.0 - ring.lean * ring.lean));
    for (int k = 0; k < sides; ++k, ++index) {
      // counterclockwise seen from the base, so that triangles face outward
      const double angle = -2.0 * pi * k / sides;
      const Eigen::Vector3d radial = std::cos(angle) * center.inner + std::sin(angle) * center.side;
      mesh.point(index) = (center.place + ring.radius_mm * radial).cast<float>();
      mesh.normal(index) = (outward * radial + ring.lean * center.along).cast<float>();
    }
  }
  mesh.pointsChanged();
}

void ArrayParts::showContacts(const ArrayPath& path)
{
  // Rows and columns are close together at the rim, so that the rim appears as a line.
  const double rimFraction = 0.10;
  const auto spread = [&](int i, int count) {
    if (i == 0) return -1.0;
    if (i == count - 1) return 1.0;
    return (1.0 - rimFraction) * (2.0 * (i - 1) / (count - 3) - 1.0);
  };
  const double halfLength_mm = 0.5 * inMillimeters(array_.contactLength);
  int index = 0;
  for (const Length contact : array_.contactsFromTip)
    for (int a = 0; a < contactAlong; ++a) {
      const double fromTip_mm = inMillimeters(contact) + halfLength_mm * spread(a, contactAlong);
      const PathPoint center = path.at(fromTip_mm);
      const double radius = radius_mm(fromTip_mm) + contactLift_mm;
      for (int c = 0; c < contactAcross; ++c, ++index) {
        const double angle = -contactHalfAngle * spread(c, contactAcross);
        const Eigen::Vector3d radial =
            std::cos(angle) * center.inner + std::sin(angle) * center.side;
        contacts_.point(index) = (center.place + radius * radial).cast<float>();
        contacts_.normal(index) = radial.cast<float>();
      }
    }
  contacts_.pointsChanged();
}

void ArrayParts::show(const ArrayPath& path, double styletWithdrawal_mm)
{
  if (array_.length <= millimeters(0)) return;
  writeRings(tube_, tubeRings_, path);
  writeRings(ribs_, ribRings_, path);
  showContacts(path);
  if (array_.hasStylet) {
    std::vector<Ring> rings = styletRings_;
    for (Ring& ring : rings)
      ring.fromTip_mm += inMillimeters(array_.stylet.fromTip) + styletWithdrawal_mm;
    writeRings(stylet_, rings, path);
  }
  tweezers_.show(path);

  outlinePath_.clear();
  outlineRadius_mm_.clear();
  for (const Ring& ring : tubeRings_) {
    outlinePath_.push_back(path.at(ring.fromTip_mm));
    outlineRadius_mm_.push_back(ring.radius_mm);
  }
}

void ArrayParts::lookFrom(const ViewFrame& view)
{
  shadow_.clear();
  outline_.clear();
  for (const double sign : {-1.0, 1.0}) {
    shadow_.begin(LineEdge::glow);
    outline_.begin(LineEdge::firm);
    for (std::size_t i = 0; i < outlinePath_.size(); ++i) {
      const PathPoint& point = outlinePath_[i];
      const Eigen::Vector3d side = sign * point.along.cross(view.back);
      const double visible = side.norm();  // 0 where the array points toward the viewer
      if (visible < 1e-6) continue;
      const Eigen::Vector3d edge = point.place + (outlineRadius_mm_[i] / visible) * side;
      shadow_.add({edge, withOpacity(palette_.outline, 0.55 * visible), shadowWidth_mm});
      outline_.add({edge, withOpacity(palette_.outline, 0.75 * visible), 0.8 * view.pixel_mm});
    }
  }
  shadow_.build(view, 0.0);
  outline_.build(view, outlineLift_mm);
}

}  // namespace perilymph::visualization
