#include "perilymph/anatomy/ScalaTympani.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "CubicTable.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

/// A place in a table over the angle: the first of four coefficients, and the fraction.
struct Place {
  std::size_t first;
  double fraction;
};

Place placeIn(double index, std::size_t samples) noexcept
{
  const double last = static_cast<double>(samples - 1);
  const double inside = index < 0.0 ? 0.0 : (index > last ? last : index);
  auto first = static_cast<std::size_t>(inside);
  if (first > samples - 2) first = samples - 2;
  return {first, inside - static_cast<double>(first)};
}

double spline(const std::vector<double>& coefficients, Place place) noexcept
{
  return weighted(coefficients.data() + place.first, CubicWeights(place.fraction).value);
}

void require(bool holds, const char* sentence)
{
  if (!holds) throw std::invalid_argument(sentence);
}

}  // namespace

struct ScalaTympani::Level {
  double value;              ///< F [m].
  Eigen::Vector3d gradient;  ///< Of F by the point, in space; points into the lumen.
  double u, v;               ///< The point from the section's center, outward and apical [m].
  double angle;              ///< Of the section [rad].
  // The outline at the point's direction: tangent (outward, apical) per radian, and curvature.
  double tangentU, tangentV;
  double curvature;
};

ScalaTympani::ScalaTympani(SectionTables tables) : tables_(std::move(tables))
{
  const std::size_t sections = tables_.centerRadius.size();
  const auto directions = static_cast<std::size_t>(std::max(tables_.directions, 0));
  require(sections >= 8, "A scala tympani needs at least 8 sections.");
  require(directions >= 8, "A section needs at least 8 directions.");
  require(tables_.step > 0.0, "The angle between sections must be above 0.");
  require(tables_.leadIn >= 0.0, "The lead-in cannot be shorter than 0.");
  require(tables_.centerHeight.size() == sections && tables_.membraneInner.size() == sections &&
              tables_.membraneOuter.size() == sections && tables_.membraneHeight.size() == sections &&
              tables_.planRadius.size() == sections &&
              tables_.wallRadius.size() == sections * directions,
          "The tables of a scala tympani must have one entry for each section.");
  require(std::all_of(tables_.wallRadius.begin(), tables_.wallRadius.end(),
                      [](double radius) { return radius > 0.0; }),
          "Every wall must be off its section's center.");

  lastAngle_ = tables_.step * static_cast<double>(sections - 1);
  perStep_ = 1.0 / tables_.step;
  perDirection_ = static_cast<double>(directions) / (2.0 * pi);
  centerRadius_ = interpolatingCoefficients(tables_.centerRadius);
  centerHeight_ = interpolatingCoefficients(tables_.centerHeight);
  membraneInner_ = interpolatingCoefficients(tables_.membraneInner);
  membraneOuter_ = interpolatingCoefficients(tables_.membraneOuter);
  membraneHeight_ = interpolatingCoefficients(tables_.membraneHeight);

  // Over the angle the wall passes through the tables. Around the section the tables' values are the
  // coefficients themselves, which rounds corners over about one direction and never overshoots.
  rowLength_ = directions + 3;
  wallRadius_.resize((sections + 2) * rowLength_);
  std::vector<double> column(sections);
  for (std::size_t k = 0; k < directions; ++k) {
    for (std::size_t i = 0; i < sections; ++i) column[i] = tables_.wallRadius[i * directions + k];
    const std::vector<double> coefficients = interpolatingCoefficients(column);
    for (std::size_t i = 0; i < sections + 2; ++i) {
      wallRadius_[i * rowLength_ + k + 1] = coefficients[i];
      if (k == directions - 1) wallRadius_[i * rowLength_] = coefficients[i];
      if (k == 0) wallRadius_[i * rowLength_ + directions + 1] = coefficients[i];
      if (k == 1) wallRadius_[i * rowLength_ + directions + 2] = coefficients[i];
    }
  }

  // the lead-in goes on along the tangent of the center line; the opening is at its far end
  const CubicWeights start(0.0);
  const double r = weighted(centerRadius_.data(), start.value);
  inward_W_ = Eigen::Vector3d(weighted(centerRadius_.data(), start.slope) * perStep_, r,
                              weighted(centerHeight_.data(), start.slope) * perStep_)
                  .normalized();
  require(inward_W_.y() > 0.1, "The center line must lead into the cochlea at the round window.");
  const Eigen::Vector3d first(r, 0.0, weighted(centerHeight_.data(), start.value));
  entry_.origin_W = first - tables_.leadIn * inward_W_;
  entry_.out_W = -inward_W_;
  const Eigen::Vector3d radial = Eigen::Vector3d::UnitX();
  entry_.outward_W = (radial - radial.dot(inward_W_) * inward_W_).normalized();
  entry_.vertical_W = entry_.out_W.cross(entry_.outward_W);

  // how near the wall comes to each section's center, in the section and in space
  leastRadius_.resize(sections);
  leastSlant_.resize(sections);
  for (std::size_t i = 0; i < sections; ++i) {
    leastRadius_[i] = 1e9;
    leastSlant_[i] = 1.0;
    const double angle = static_cast<double>(i) * tables_.step;
    const SineCosine turn = sineCosine(angle);
    const double direction[2] = {turn.cosine, turn.sine};
    for (std::size_t k = 0; k < directions; ++k) {
      const Eigen::Vector3d wall = wall_W(angle, static_cast<double>(k) / perDirection_);
      const Level level = levelAt(wall, angle, direction, false);
      leastRadius_[i] = std::min(leastRadius_[i], std::sqrt(level.u * level.u + level.v * level.v));
      leastSlant_[i] = std::min(leastSlant_[i], 1.0 / level.gradient.norm());
    }
  }
}

// F and what goes with it at a point whose section is known. Two parametrizations share it: in the
// spiral the section turns with the angle, in the lead-in it slides along the straight axis.
ScalaTympani::Level ScalaTympani::levelAt(const Eigen::Vector3d& point_W, double angle,
                                          const double direction[2], bool inLeadIn) const noexcept
{
  const Place place = placeIn(angle * perStep_, tables_.centerRadius.size());
  const CubicWeights along(place.fraction);
  const double centerRadius = weighted(centerRadius_.data() + place.first, along.value);
  const double centerHeight = weighted(centerHeight_.data() + place.first, along.value);

  Level level;
  level.angle = angle;
  Eigen::Vector3d uGradient, vGradient, angleGradient;
  if (inLeadIn) {
    const double forward = point_W.y() / inward_W_.y();
    level.u = point_W.x() - forward * inward_W_.x() - centerRadius;
    level.v = point_W.z() - forward * inward_W_.z() - centerHeight;
    uGradient = {1.0, -inward_W_.x() / inward_W_.y(), 0.0};
    vGradient = {0.0, -inward_W_.z() / inward_W_.y(), 1.0};
    angleGradient.setZero();
  } else {
    const double r = point_W.x() * direction[0] + point_W.y() * direction[1];
    level.u = r - centerRadius;
    level.v = point_W.z() - centerHeight;
    const bool pastEnd = angle > lastAngle_;
    const double perAngle = pastEnd ? 0.0 : 1.0 / std::max(r, 1e-5);
    angleGradient = {-direction[1] * perAngle, direction[0] * perAngle, 0.0};
    const double radiusSlope = weighted(centerRadius_.data() + place.first, along.slope) * perStep_;
    const double heightSlope = weighted(centerHeight_.data() + place.first, along.slope) * perStep_;
    uGradient = Eigen::Vector3d(direction[0], direction[1], 0.0) - radiusSlope * angleGradient;
    vGradient = Eigen::Vector3d(0.0, 0.0, 1.0) - heightSlope * angleGradient;
  }

  // the wall's distance from the center in the point's direction, with its slopes
  const double off = std::max(std::sqrt(level.u * level.u + level.v * level.v), 1e-9);
  double around = arcTangent(level.v, level.u);
  if (around < 0.0) around += 2.0 * pi;
  const double index = around * perDirection_;
  auto column = static_cast<std::size_t>(index);
  if (column > rowLength_ - 4) column = rowLength_ - 4;
  const CubicWeights across(index - static_cast<double>(column));
  double radius = 0.0, radiusByAngle = 0.0, radiusAround = 0.0, radiusBend = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double* row = wallRadius_.data() + (place.first + k) * rowLength_ + column;
    const double value = weighted(row, across.value);
    radius += along.value[k] * value;
    radiusByAngle += along.slope[k] * value;
    radiusAround += along.value[k] * weighted(row, across.slope);
    radiusBend += along.value[k] * weighted(row, across.bend);
  }
  radiusByAngle *= perStep_;
  radiusAround *= perDirection_;
  radiusBend *= perDirection_ * perDirection_;

  const double cosine = level.u / off;
  const double sine = level.v / off;
  level.value = radius - off;
  level.gradient = radiusByAngle * angleGradient - (cosine * uGradient + sine * vGradient) +
                   (radiusAround / off) * (cosine * vGradient - sine * uGradient);

  // the outline as a curve in polar form
  level.tangentU = radiusAround * cosine - radius * sine;
  level.tangentV = radiusAround * sine + radius * cosine;
  const double speed2 = radius * radius + radiusAround * radiusAround;
  level.curvature = (radius * radius + 2.0 * radiusAround * radiusAround - radius * radiusBend) /
                    (speed2 * std::sqrt(speed2));
  return level;
}

void ScalaTympani::nearestWall(std::span<const Eigen::Vector3d> points_W,
                               std::span<const double> reach, std::span<LumenTrack> tracks,
                               std::span<WallPoint> walls) const noexcept
{
  for (std::size_t i = 0; i < points_W.size(); ++i)
    locate(points_W[i], reach[i], tracks[i], walls[i]);
}

void ScalaTympani::locate(const Eigen::Vector3d& point_W, double reach, LumenTrack& track,
                          WallPoint& wall) const noexcept
{
  wall.isNear = false;
  if ((point_W - entry_.origin_W).dot(inward_W_) < 0.0) {
    track = LumenTrack{};
    return;
  }

  // the angle, in the turn the point remembers
  const bool inLeadIn = track.angle < 0.5 * pi && point_W.y() < 0.0 && point_W.x() > 0.0;
  if (inLeadIn) {
    track = LumenTrack{};
  } else {
    const double r = std::sqrt(point_W.x() * point_W.x() + point_W.y() * point_W.y());
    if (!(r > 1e-6)) return;  // on the modiolar axis, or not a number: no angle, and no wall near
    const double direction[2] = {point_W.x() / r, point_W.y() / r};
    track.angle += arcTangent(direction[1] * track.direction[0] - direction[0] * track.direction[1],
                              direction[0] * track.direction[0] + direction[1] * track.direction[1]);
    if (track.angle < 0.0) track.angle = 0.0;
    track.direction[0] = direction[0];
    track.direction[1] = direction[1];
  }

  // far from every wall of the section: that is all anyone asks
  const double clamped = std::min(track.angle, lastAngle_);
  const auto section = static_cast<std::size_t>(clamped * perStep_ + 0.5);
  Level level = levelAt(point_W, track.angle, track.direction, inLeadIn);
  const double off2 = level.u * level.u + level.v * level.v;
  const double clear = leastRadius_[section] - reach / leastSlant_[section];
  const double toEnd = (lastAngle_ - track.angle) * (tables_.centerRadius[section] + level.u);
  if (clear > 0.0 && off2 < 0.81 * clear * clear && toEnd > reach) return;

  // first order, then once more from the foot on the wall
  double steep = level.gradient.norm();
  wall.distance = level.value / steep;
  wall.normal_W = level.gradient / steep;
  if (wall.distance > 2.0 * reach && toEnd > reach) return;
  const double turnTo = inLeadIn ? 0.0 : 1.0;
  for (int pass = 0; pass < 0; ++pass) {
    const Eigen::Vector3d foot = point_W - wall.distance * wall.normal_W;
    double angle = track.angle;
    double direction[2] = {track.direction[0], track.direction[1]};
    if (turnTo > 0.0) {
      const double r = std::sqrt(foot.x() * foot.x() + foot.y() * foot.y());
      if (!(r > 1e-6)) break;
      direction[0] = foot.x() / r;
      direction[1] = foot.y() / r;
      angle += arcTangent(direction[1] * track.direction[0] - direction[0] * track.direction[1],
                          direction[0] * track.direction[0] + direction[1] * track.direction[1]);
      if (angle < 0.0) angle = 0.0;
    }
    level = levelAt(foot, angle, direction, inLeadIn);
    steep = level.gradient.norm();
    wall.normal_W = level.gradient / steep;
    wall.distance = (point_W - foot).dot(wall.normal_W) + level.value / steep;
  }

  // the outline's tangent in space, and how fast the normal turns along it and along the duct
  const Eigen::Vector3d outward(track.direction[0], track.direction[1], 0.0);
  wall.along_W = (level.tangentU * outward + level.tangentV * Eigen::Vector3d::UnitZ());
  const double tangentLength = wall.along_W.norm();
  wall.along_W /= tangentLength;
  const double inPlane = (-level.tangentV * wall.normal_W.dot(outward) +
                          level.tangentU * wall.normal_W.z()) / tangentLength;
  const double bend = level.curvature * inPlane;
  wall.curvature = bend / std::max(1.0 - bend * wall.distance, 0.2);
  wall.lengthwiseCurvature = 0.0;
  if (!inLeadIn) {
    const double r = point_W.x() * outward.x() + point_W.y() * outward.y();
    wall.lengthwiseCurvature = -wall.normal_W.dot(outward) / std::max(r, 1e-4);
  }
  wall.onMembrane = onMembrane(level);

  // the apex: the last section is a wall across the duct
  if (toEnd < wall.distance) {
    wall.distance = toEnd;
    wall.normal_W = Eigen::Vector3d(track.direction[1], -track.direction[0], 0.0);
    wall.along_W = Eigen::Vector3d::UnitZ();
    wall.curvature = 0.0;
    wall.lengthwiseCurvature = 0.0;
    wall.onMembrane = false;
  }
  wall.isNear = wall.distance <= reach;
}

bool ScalaTympani::onMembrane(const Level& foot) const noexcept
{
  const Place place = placeIn(foot.angle * perStep_, tables_.centerRadius.size());
  const CubicWeights along(place.fraction);
  const double height = weighted(membraneHeight_.data() + place.first, along.value);
  return foot.v > 0.7 * height &&
         foot.u > weighted(membraneInner_.data() + place.first, along.value) &&
         foot.u < weighted(membraneOuter_.data() + place.first, along.value);
}

Eigen::Vector3d ScalaTympani::center_W(double angle) const noexcept
{
  if (angle < 0.0) return entry_.origin_W;
  const Place place = placeIn(angle * perStep_, tables_.centerRadius.size());
  const SineCosine turn = sineCosine(angle);
  const double r = spline(centerRadius_, place);
  return {r * turn.cosine, r * turn.sine, spline(centerHeight_, place)};
}

Eigen::Vector3d ScalaTympani::wall_W(double angle, double direction) const noexcept
{
  const Place place = placeIn(std::max(angle, 0.0) * perStep_, tables_.centerRadius.size());
  const CubicWeights along(place.fraction);
  const double turns = direction / (2.0 * pi);
  const double index = (turns - std::floor(turns)) * static_cast<double>(tables_.directions);
  auto column = static_cast<std::size_t>(index);
  if (column > rowLength_ - 4) column = rowLength_ - 4;
  const CubicWeights across(index - static_cast<double>(column));
  double radius = 0.0;
  for (std::size_t k = 0; k < 4; ++k)
    radius += along.value[k] *
              weighted(wallRadius_.data() + (place.first + k) * rowLength_ + column, across.value);

  const SineCosine around = sineCosine(direction);
  const SineCosine turn = sineCosine(std::max(angle, 0.0));
  const double r = spline(centerRadius_, place) + radius * around.cosine;
  Eigen::Vector3d wall(r * turn.cosine, r * turn.sine,
                       spline(centerHeight_, place) + radius * around.sine);
  if (angle < 0.0) wall -= tables_.leadIn * inward_W_;
  return wall;
}

Section ScalaTympani::section(double angle) const
{
  constexpr int steps = 720;
  const Eigen::Vector3d center = center_W(std::max(angle, 0.0));
  Section result{};
  result.centerRadius = std::sqrt(center.x() * center.x() + center.y() * center.y());
  result.centerHeight = center.z();
  result.innerRadius = result.floorHeight = 1e9;
  result.outerRadius = result.roofHeight = -1e9;
  const SineCosine turn = sineCosine(std::max(angle, 0.0));
  double previousR = 0.0, previousZ = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const Eigen::Vector3d wall = wall_W(std::max(angle, 0.0), 2.0 * pi * k / steps);
    const double r = wall.x() * turn.cosine + wall.y() * turn.sine;
    result.innerRadius = std::min(result.innerRadius, r);
    result.outerRadius = std::max(result.outerRadius, r);
    result.floorHeight = std::min(result.floorHeight, wall.z());
    result.roofHeight = std::max(result.roofHeight, wall.z());
    if (k > 0) result.area += 0.5 * (previousR * wall.z() - r * previousZ);
    previousR = r;
    previousZ = wall.z();
  }
  return result;
}

Eigen::Vector3d ScalaTympani::membrane_W(double angle, double across) const noexcept
{
  const Place place = placeIn(std::max(angle, 0.0) * perStep_, tables_.centerRadius.size());
  const SineCosine turn = sineCosine(std::max(angle, 0.0));
  const double inner = spline(membraneInner_, place);
  const double outer = spline(membraneOuter_, place);
  const double r = spline(centerRadius_, place) + inner + across * (outer - inner);
  return {r * turn.cosine, r * turn.sine,
          spline(centerHeight_, place) + spline(membraneHeight_, place)};
}

}  // namespace perilymph::anatomy
