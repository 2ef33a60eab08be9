// SPDX-License-Identifier: BSD-3-Clause
#include "LumenWall.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

constexpr double cupola_mm = 0.5;
// The center of the modiolus in the basal turn is on W's axis.
constexpr double basalMiddle_mm = 0.4;

/// Distance to the wall of one turn on a ray from the center of its section, as a multiple of `unit` that is
/// the last inside. Newton's steps find it, because sections are convex; else bisection.
double distanceToWall(const MeanLumen& mean, const SectionPlace& place, double angle,
                      const SineCosine& direction)
{
  constexpr int halvings = 24;
  constexpr double last = 3.0;
  constexpr double unit = last / (1 << halvings);
  const double middleU = -0.5 * mean.width(angle);
  const auto at = [&](double along) {
    const double u = middleU + along * direction.cosine / place.width;
    const double fromOuter = u * place.width;
    const double v =
        (along * direction.sine - place.tilt * (fromOuter - middleU * place.width)) / place.height;
    return mean.distance(angle, u, v);
  };
  const auto isInside = [&](double along) { return at(along).inside > 0.0; };

  const double byU = direction.cosine / place.width;
  const double byV = (direction.sine - place.tilt * direction.cosine) / place.height;
  double found = 1.2;  // outside, from where the steps do not overshoot
  for (int i = 0; i < 8; ++i) {
    const SectionDistance here = at(found);
    const double slope = here.du * byU + here.dv * byV;
    if (!(slope < 0.0)) break;  // where the wall ahead is not the nearest
    const double next = std::clamp(found - here.inside / slope, 0.0, last);
    const bool isThere = std::fabs(next - found) < 0.25 * unit;
    found = next;
    if (isThere) break;
  }
  const double units = std::floor(found / unit);
  for (const double off : {0.0, -1.0, 1.0}) {
    const double low = (units + off) * unit;
    if (low > 0.0 && low + unit < last && isInside(low) && !isInside(low + unit)) return low;
  }
  double low = 0.0, high = last;
  for (int i = 0; i < halvings; ++i) {
    const double half = 0.5 * (low + high);
    (isInside(half) ? low : high) = half;
  }
  return low;
}

/// Maximum radius of a ring about the frame's axis, and its angle.
struct Outermost {
  double angle, radius;
};

std::vector<Outermost> outerLine(const LumenWall& wall, const ClinicalFrame& frame)
{
  std::vector<Outermost> line;
  double before = 0.0;
  for (int ring = 0; ring < wall.rings(); ++ring) {
    Eigen::Vector3d outermost = Eigen::Vector3d::Zero();
    for (int k = 0; k < LumenWall::around; ++k) {
      const Eigen::Vector3d point = frame.from_W(wall.at(ring, k));
      if (point.head<2>().norm() > outermost.head<2>().norm()) outermost = point;
    }
    double angle = arcTangent(outermost.y(), outermost.x());
    if (ring == 0 && angle > pi) angle -= 2.0 * pi;
    while (ring > 0 && angle < before - pi) angle += 2.0 * pi;
    before = angle;
    line.push_back({angle, outermost.head<2>().norm()});
  }
  return line;
}

double radiusAt(const std::vector<Outermost>& line, double angle)
{
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    if (line[i].angle <= angle && angle <= line[i + 1].angle) {
      const double t = (angle - line[i].angle) / std::max(1e-9, line[i + 1].angle - line[i].angle);
      return line[i].radius + t * (line[i + 1].radius - line[i].radius);
    }
  return 0.0;
}

}  // namespace

LumenWall wallOf(const ShapedLumen& lumen, double firstAngle)
{
  LumenWall wall;
  wall.firstAngle = firstAngle;
  const MeanLumen& mean = lumen.mean();
  for (double angle = firstAngle; angle <= mean.lastAngle(); angle += LumenWall::step) {
    const SectionPlace place = lumen.place(angle);
    const SineCosine turn = sineCosine(angle);
    const double middleRadius = place.outer - 0.5 * place.width * mean.width(angle);
    const double middleHeight = place.middle - 0.5 * place.tilt * place.width * mean.width(angle);
    for (int k = 0; k < LumenWall::around; ++k) {
      const SineCosine direction = sineCosine(2.0 * pi * k / LumenWall::around);
      const double distance = distanceToWall(mean, place, angle, direction);
      const double r = middleRadius + distance * direction.cosine;
      wall.points_W.emplace_back(r * turn.cosine, r * turn.sine,
                                 middleHeight + distance * direction.sine);
    }
  }
  return wall;
}

Eigen::Vector3d cupola_W(const LumenWall& wall)
{
  double highest = -1e9;
  for (const Eigen::Vector3d& point : wall.points_W) highest = std::max(highest, point.z());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (const Eigen::Vector3d& point : wall.points_W)
    if (point.z() > highest - cupola_mm) {
      sum += point;
      count += 1.0;
    }
  return sum / count;
}

Eigen::Vector3d modiolusBase_W() { return {0.0, 0.0, basalMiddle_mm}; }

Eigen::Vector3d clinicalAxis_W(const LumenWall& mean)
{
  return (cupola_W(mean) - modiolusBase_W()).normalized();
}

ClinicalFrame clinicalFrame(const Eigen::Vector3d& axis, const Eigen::Vector3d& roundWindow_W)
{
  const Eigen::Vector3d base = modiolusBase_W();
  ClinicalFrame frame;
  frame.origin_W = base + (roundWindow_W - base).dot(axis) * axis;
  frame.axes_W.col(2) = axis;
  frame.axes_W.col(0) = (roundWindow_W - frame.origin_W).normalized();
  frame.axes_W.col(1) = axis.cross(frame.axes_W.col(0));
  return frame;
}

WallMeasures measureWall(const LumenWall& wall, const ClinicalFrame& frame,
                         const Eigen::Vector3d& roundWindow_W)
{
  const std::vector<Outermost> line = outerLine(wall, frame);
  WallMeasures measures{};
  measures.a = frame.from_W(roundWindow_W).head<2>().norm() + radiusAt(line, pi);
  measures.b = radiusAt(line, 0.5 * pi) + radiusAt(line, 1.5 * pi);
  double low = 1e9, high = -1e9;
  for (const Eigen::Vector3d& point : wall.points_W) {
    const double z = frame.from_W(point).z();
    low = std::min(low, z);
    high = std::max(high, z);
  }
  measures.h = high - low;
  return measures;
}

}  // namespace perilymph::ct
