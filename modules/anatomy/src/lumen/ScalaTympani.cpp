// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/ScalaTympani.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "lumen/LumenField.h"
#include "lumen/ScalaeAbove.h"
#include "lumen/SectionWall.h"
#include "numerics/CubicTable.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

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

struct ScalaTympani::WallQuery {
  std::once_flag once;
  std::unique_ptr<const LumenField> table;
  std::atomic<const LumenField*> built{nullptr};  ///< For the tick, which must not wait.
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
              tables_.membraneOuter.size() == sections &&
              tables_.membraneHeight.size() == sections && tables_.planRadius.size() == sections &&
              tables_.wallRadius.size() == sections * directions,
          "The tables of a scala tympani must have one entry for each section.");
  require(std::all_of(tables_.wallRadius.begin(), tables_.wallRadius.end(),
                      [](double radius) { return radius > 0.0; }),
          "Every wall must be off its section's center.");

  lastAngle_ = tables_.step * static_cast<double>(sections - 1);
  centerRadius_ = interpolatingCoefficients(tables_.centerRadius);
  centerHeight_ = interpolatingCoefficients(tables_.centerHeight);
  membraneInner_ = interpolatingCoefficients(tables_.membraneInner);
  membraneOuter_ = interpolatingCoefficients(tables_.membraneOuter);
  membraneHeight_ = interpolatingCoefficients(tables_.membraneHeight);

  // Over the angle the wall interpolates the tables. Around the section the table values are the
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

  // the lead-in continues along the tangent of the center line; the opening is at its far end
  const CubicWeights start(0.0);
  const double r = weighted(centerRadius_.data(), start.value);
  const Eigen::Vector3d inward_W =
      Eigen::Vector3d(weighted(centerRadius_.data(), start.slope) / tables_.step, r,
                      weighted(centerHeight_.data(), start.slope) / tables_.step)
          .normalized();
  require(inward_W.y() > 0.1, "The center line must lead into the cochlea at the round window.");
  const Eigen::Vector3d first(r, 0.0, weighted(centerHeight_.data(), start.value));
  entry_.origin_W = first - tables_.leadIn * inward_W;
  entry_.out_W = -inward_W;
  const Eigen::Vector3d radial = Eigen::Vector3d::UnitX();
  entry_.outward_W = (radial - radial.dot(inward_W) * inward_W).normalized();
  entry_.vertical_W = entry_.out_W.cross(entry_.outward_W);

  wall_ = std::make_unique<WallQuery>();
  above_ = std::make_unique<ScalaeAbove>();
}

ScalaTympani::~ScalaTympani() = default;

void ScalaTympani::prepare() const
{
  std::call_once(wall_->once, [this] {
    wall_->table = std::make_unique<const LumenField>(*this);
    wall_->built = wall_->table.get();
  });
}

const LumenField& ScalaTympani::field() const noexcept
{
  if (const LumenField* const built = wall_->built) return *built;
  prepare();
  return *wall_->table;
}

void ScalaTympani::nearestWall(std::span<const Eigen::Vector3d> points_W,
                               std::span<const double> reach, std::span<LumenTrack> tracks,
                               std::span<WallPoint> walls) const noexcept
{
  const LumenField& table = field();
  for (std::size_t i = 0; i < points_W.size(); ++i)
    table.locate(points_W[i], reach[i], tracks[i], walls[i]);
}

void ScalaTympani::follow(const Eigen::Vector3d& point_W, LumenTrack& track) const noexcept
{
  field().follow(point_W, track);
}

void ScalaTympani::addTo(Hash& hash) const noexcept
{
  // Names all members, so that this does not compile once a member is added.
  const auto& [name, step, centerRadius, centerHeight, directions, wallRadius, membraneInner,
               membraneOuter, membraneHeight, planRadius, leadIn, measuredTo] = tables_;
  hash.add(step);
  hash.add(directions);
  hash.add(leadIn);
  hash.add(measuredTo);
  for (const auto* values : {&centerRadius, &centerHeight, &wallRadius, &membraneInner,
                             &membraneOuter, &membraneHeight, &planRadius})
    for (const double value : *values) hash.add(value);
}

Eigen::Vector3d ScalaTympani::center_W(double angle) const noexcept
{
  if (angle < 0.0) return entry_.origin_W;
  const Place place = placeIn(angle / tables_.step, tables_.centerRadius.size());
  const SineCosine turn = sineCosine(angle);
  const double r = spline(centerRadius_, place);
  return {r * turn.cosine, r * turn.sine, spline(centerHeight_, place)};
}

SectionWall::SectionWall(const ScalaTympani& scala, double angle) noexcept
    : SectionWall(
          scala, angle,
          placeIn(std::max(angle, 0.0) / scala.tables_.step, scala.tables_.centerRadius.size()))
{
}

SectionWall::SectionWall(const ScalaTympani& scala, double angle, Place place) noexcept
    : scala_(scala),
      rows_(scala.wallRadius_.data() + place.first * scala.rowLength_),
      along_(place.fraction),
      turn_(sineCosine(std::max(angle, 0.0))),
      centerRadius_(spline(scala.centerRadius_, place)),
      centerHeight_(spline(scala.centerHeight_, place)),
      isLeadIn_(angle < 0.0)
{
}

Place SectionWall::indexOf(double direction) const noexcept
{
  const double turns = direction / (2.0 * pi);
  const double index = (turns - std::floor(turns)) * static_cast<double>(scala_.tables_.directions);
  auto first = static_cast<std::size_t>(index);
  if (first > scala_.rowLength_ - 4) first = scala_.rowLength_ - 4;
  return {first, index - static_cast<double>(first)};
}

Eigen::Vector3d SectionWall::at(double direction, const SineCosine& around) const noexcept
{
  const std::size_t rowLength = scala_.rowLength_;
  const auto [column, fraction] = indexOf(direction);
  const CubicWeights across(fraction);
  double radius = 0.0;
  for (std::size_t k = 0; k < 4; ++k)
    radius += along_.value[k] * weighted(rows_ + k * rowLength + column, across.value);

  const double r = centerRadius_ + radius * around.cosine;
  Eigen::Vector3d wall(r * turn_.cosine, r * turn_.sine, centerHeight_ + radius * around.sine);
  if (isLeadIn_) wall += scala_.tables_.leadIn * scala_.entry_.out_W;
  return wall;
}

SectionWall::Radii SectionWall::radii() const noexcept
{
  const auto [min, max] = std::minmax_element(rows_, rows_ + 4 * scala_.rowLength_);
  return {*min, *max};
}

std::vector<SectionWall::Radii> SectionWall::radiiOfSteps() const
{
  const std::size_t rowLength = scala_.rowLength_;
  std::vector<Radii> ofColumn(rowLength, Radii{1e9, 0.0});
  for (std::size_t column = 0; column < rowLength; ++column)
    for (std::size_t k = 0; k < 4; ++k) {
      const double radius = rows_[k * rowLength + column];
      ofColumn[column] = {std::min(ofColumn[column].min, radius),
                          std::max(ofColumn[column].max, radius)};
    }
  std::vector<Radii> steps(ofColumn.begin(), ofColumn.end() - 3);
  for (std::size_t step = 0; step < steps.size(); ++step)
    for (std::size_t k = 1; k < 4; ++k)
      steps[step] = {std::min(steps[step].min, ofColumn[step + k].min),
                     std::max(steps[step].max, ofColumn[step + k].max)};
  return steps;
}

Eigen::Vector3d ScalaTympani::wall_W(double angle, double direction) const noexcept
{
  return SectionWall(*this, angle).at(direction);
}

Section ScalaTympani::section(double angle) const
{
  constexpr int steps = 720;
  const Eigen::Vector3d center = center_W(std::max(angle, 0.0));
  const SectionWall outline(*this, std::max(angle, 0.0));
  Section result{};
  result.centerRadius = std::sqrt(center.x() * center.x() + center.y() * center.y());
  result.centerHeight = center.z();
  result.innerRadius = result.floorHeight = 1e9;
  result.outerRadius = result.roofHeight = -1e9;
  const SineCosine turn = sineCosine(std::max(angle, 0.0));
  double previousR = 0.0, previousZ = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const Eigen::Vector3d wall = outline.at(2.0 * pi * k / steps);
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
  const Place place = placeIn(std::max(angle, 0.0) / tables_.step, tables_.centerRadius.size());
  const SineCosine turn = sineCosine(std::max(angle, 0.0));
  const double inner = spline(membraneInner_, place);
  const double outer = spline(membraneOuter_, place);
  const double r = spline(centerRadius_, place) + inner + across * (outer - inner);
  return {r * turn.cosine, r * turn.sine,
          spline(centerHeight_, place) + spline(membraneHeight_, place)};
}

}  // namespace perilymph::anatomy
