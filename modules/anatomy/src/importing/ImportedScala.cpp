// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/ImportedScala.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "importing/AxialSections.h"
#include "importing/ClosedSurface.h"
#include "importing/ModiolarAxis.h"
#include "importing/NumberText.h"
#include "importing/SurfaceOpening.h"
#include "importing/SurfaceRims.h"
#include "lumen/GridLumen.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

constexpr int axisRounds = 6;  // the duct is tracked again about each improved axis
// The hook region at the base is not a spiral: the axis is fitted from this angle on.
constexpr double spiralFrom_deg = 20.0;
constexpr double minTurns = 1.25;  // fewer do not determine the axis and the radius at 270 degrees
// Human scalae have up to three turns; more indicates a closed ring or a ball.
constexpr double maxTurns = 3.5;

// Scalae open at the round window have 0.7 to 0.8 mm, and holes in their walls more than 5 mm [m].
constexpr double maxOffBase = 2.5e-3;

// Of 14 surfaces and of 30 with noise of 10 um, the rim's outermost corner is within 0.05 mm of the
// section through the rim's center [m].
constexpr double maxRimOff = 0.1e-3;

double polar(const Eigen::Vector3d& point) { return arcTangent(point.y(), point.x()); }

double radius(const Eigen::Vector3d& point)
{
  return std::sqrt(point.x() * point.x() + point.y() * point.y());
}

/// The angle equal to `angle` modulo full turns that is nearest to `other`.
double inTurnOf(double angle, double other)
{
  return angle + 2.0 * pi * std::round((other - angle) / (2.0 * pi));
}

/// Distance of the outer wall from the axis at an angle, linear between sections.
double outerRadius(const std::vector<AxialSection>& duct, double angle)
{
  std::size_t i = 1;
  while (i + 1 < duct.size() && duct[i].angle < angle) ++i;
  const AxialSection& a = duct[i - 1];
  const AxialSection& b = duct[i];
  const double fraction = std::clamp((angle - a.angle) / (b.angle - a.angle), 0.0, 1.0);
  return a.outerRadius + fraction * (b.outerRadius - a.outerRadius);
}

/// The section at zero degrees, where the spiral begins.
struct RoundWindow {
  Eigen::Vector3d center;  ///< In the file's frame.
  double angle;            ///< In the axis frame, in the turn of the duct's sections.
  double outerRadius, floorHeight, roofHeight;
};

RoundWindow roundWindowAtRim(const ClosedSurface& closed, const SurfaceOpening& opening,
                             const AxisFrame& frame, const std::vector<AxialSection>& duct)
{
  const Eigen::Vector3d carried = opening.leadIn * opening.inward;
  RoundWindow window{opening.center + carried, 0.0, 0.0, 1e9, -1e9};
  window.angle = inTurnOf(polar(frame.into(window.center)), duct.front().angle);
  for (const Eigen::Vector3d& p : closed.rim) {
    const Eigen::Vector3d place = frame.into(p + carried);
    window.outerRadius = std::max(window.outerRadius, radius(place));
    window.floorHeight = std::min(window.floorHeight, place.z());
    window.roofHeight = std::max(window.roofHeight, place.z());
  }
  return window;
}

RoundWindow roundWindowAtEnd(const AxisFrame& frame, const AxialSection& first)
{
  const SineCosine turn = sineCosine(first.angle);
  return {frame.outOf({first.centerRadius * turn.cosine, first.centerRadius * turn.sine,
                       first.centerHeight}),
          first.angle, first.outerRadius, first.floorHeight, first.roofHeight};
}

/// Refuses an opening that is not at the basal end of the duct: a hole in its wall, which a closed
/// surface would be measured from.
Result<void> checkAtBase(const SurfaceOpening& opening, const RoundWindow& window,
                         const AxisFrame& frame, const AxialSection& first)
{
  const Eigen::Vector3d base = roundWindowAtEnd(frame, first).center;
  const double off = std::min((opening.center - base).norm(), (window.center - base).norm());
  if (off <= maxOffBase) return {};
  const Eigen::Vector3d place = 1e3 * opening.center;
  return Error{
      "The surface has a hole at (%1, %2, %3) mm, %4 mm from the basal end of its duct, where only "
      "the round window may be open. Close it in the segmentation program.",
      inText(place.x(), "%.2f"), inText(place.y(), "%.2f"), inText(place.z(), "%.2f"),
      inText(1e3 * off, "%.1f")};
}

/// Along the duct at its first section, from the third one on.
Eigen::Vector3d startDirection(const AxisFrame& frame, const std::vector<AxialSection>& duct)
{
  const auto center = [&](const AxialSection& section) {
    const SineCosine turn = sineCosine(section.angle);
    return frame.outOf({section.centerRadius * turn.cosine, section.centerRadius * turn.sine,
                        section.centerHeight});
  };
  std::size_t later = 1;
  while (later + 1 < duct.size() && duct[later].angle < duct[0].angle + degrees(4).si()) ++later;
  return (center(duct[later]) - center(duct[0])).normalized();
}

/// What raises doubts of the measures of a surface that was read.
std::vector<ImportDoubt> doubtsOf(const ClosedSurface& closed, const ImportedScala& scala,
                                  double rimOff)
{
  std::vector<ImportDoubt> doubts;
  if (closed.spike)
    doubts.push_back(
        {"spiked_wall", "A corner of the surface at " +
                            placeOf(closed.surface, closed.spike->corner) + " stands " +
                            inText(1e3 * closed.spike->height, "%.2f") +
                            " mm out of the wall around it: A, B and H may be wrong by as much. "
                            "Smooth the surface there in the segmentation program."});
  if (rimOff > maxRimOff)
    doubts.push_back({"opening_in_doubt",
                      "The rim of the opening lies " + inText(1e3 * rimOff, "%.2f") +
                          " mm from the wall of the section through its center, seen from the "
                          "axis: A and H may be wrong by as much. Cut the surface straight across "
                          "at the round window, or close it there."});
  if (areOutOfProportion(scala.a, scala.b, scala.h))
    doubts.push_back({"unusual_proportions",
                      "B does not fit A, or H is beyond that of known cochleae: check the scan's "
                      "voxel size and the segmentation."});
  return doubts;
}

/// The surface in W; all triangles or those that are wall.
Surface placed(const ClosedSurface& closed, const ImportPlace& place, bool withLid)
{
  Surface surface;
  for (const auto& p : closed.surface.points) {
    const Eigen::Vector3d point_W = place.into_W({p[0], p[1], p[2]});
    surface.points.push_back({point_W.x(), point_W.y(), point_W.z()});
  }
  const bool isMirrored = place.axes_IW.determinant() < 0.0;
  for (std::size_t i = 0; i < closed.isLid.size(); ++i) {
    if (closed.isLid[i] && !withLid) continue;
    auto t = closed.surface.triangles[i];
    if (isMirrored) std::swap(t[1], t[2]);
    surface.triangles.push_back(t);
  }
  return surface;
}

}  // namespace

Result<ImportedScala> importScala(const Surface& segmented)
{
  auto closed = closeSurface(segmented);
  if (!closed) return closed.error();
  auto axis = spiralAxis(closed->surface);
  const Error noSpiral{
      "The surface does not wind about an axis as a scala tympani does. Keep the scala tympani "
      "alone, "
      "without vestibule and scala vestibuli."};
  if (!axis) return noSpiral;

  // the axis and the duct about it
  std::vector<AxialSection> duct = followDuct(closed->surface, *axis);
  for (int round = 0; round < axisRounds && duct.size() > 2; ++round) {
    const double from = duct.front().angle + degrees(spiralFrom_deg).si();
    if (duct.back().angle - from < pi) return noSpiral;
    *axis = straightened(*axis, duct, from, duct.back().angle);
    duct = followDuct(closed->surface, *axis);
  }
  if (duct.size() <= 2 || duct.back().angle - duct.front().angle > 2.0 * pi * maxTurns)
    return noSpiral;

  // the round window
  SurfaceOpening opening;
  const bool isOpen = !closed->rim.empty();
  if (isOpen) opening = openingOf(*closed);
  const RoundWindow window = isOpen ? roundWindowAtRim(*closed, opening, *axis, duct)
                                    : roundWindowAtEnd(*axis, duct.front());
  if (isOpen)
    if (const auto fine = checkAtBase(opening, window, *axis, duct.front()); !fine)
      return fine.error();
  const double last = duct.back().angle - window.angle;
  if (last < 2.0 * pi * minTurns)
    return Error{
        "The duct winds %1 turns about its axis; at least %2 are needed to measure it. Segment the "
        "scala tympani farther toward the apex.",
        inText(last / (2.0 * pi), "%.2f"), inText(minTurns, "%.2f")};
  if (!isOpen) {
    opening.center = window.center;
    opening.inward = startDirection(*axis, duct);
    openAt(*closed, opening.center, opening.inward);
  }

  ImportedScala scala;
  scala.volume = closed->volume;
  scala.lastAngle = radians(last);
  scala.leadIn = meters(opening.leadIn);
  scala.a = meters(window.outerRadius + outerRadius(duct, window.angle + pi));
  scala.b = meters(outerRadius(duct, window.angle + 0.5 * pi) +
                   outerRadius(duct, window.angle + 1.5 * pi));
  double floor = window.floorHeight, roof = window.roofHeight;
  for (const AxialSection& section : duct) {
    if (section.angle < window.angle) continue;
    floor = std::min(floor, section.floorHeight);
    roof = std::max(roof, section.roofHeight);
  }
  scala.h = meters(roof - floor);

  // W: x through the round window, z toward the apex; where that makes angles run backward,
  // mirrored
  const bool isRight = duct.back().centerHeight > axis->into(window.center).z();
  scala.side = isRight ? Side::right : Side::left;
  const Eigen::Vector3d atWindow = axis->into(window.center);
  scala.place.origin_I = axis->outOf({0.0, 0.0, atWindow.z()});
  const double r = radius(atWindow);
  scala.place.axes_IW.col(0) =
      axis->axes * Eigen::Vector3d(atWindow.x() / r, atWindow.y() / r, 0.0);
  scala.place.axes_IW.col(1) =
      axis->axes * Eigen::Vector3d(-atWindow.y() / r, atWindow.x() / r, 0.0);
  scala.place.axes_IW.col(2) = isRight ? Eigen::Vector3d(axis->axes.col(2)) : -axis->axes.col(2);

  scala.wall_W = placed(*closed, scala.place, false);
  scala.closed_W = placed(*closed, scala.place, true);
  scala.entry.origin_W = scala.place.into_W(opening.center);
  scala.entry.out_W = -(scala.place.axes_IW.transpose() * opening.inward);
  const Eigen::Vector3d radial = Eigen::Vector3d::UnitX();
  scala.entry.outward_W = (radial - radial.dot(scala.entry.out_W) * scala.entry.out_W).normalized();
  scala.entry.vertical_W = scala.entry.out_W.cross(scala.entry.outward_W);
  scala.doubts =
      doubtsOf(*closed, scala,
               isOpen ? std::fabs(window.outerRadius - outerRadius(duct, window.angle)) : 0.0);
  return scala;
}

std::shared_ptr<const Lumen> lumenOf(const ImportedScala& scala)
{
  return std::make_shared<const GridLumen>(scala.wall_W, scala.closed_W, scala.entry);
}

}  // namespace perilymph::anatomy
