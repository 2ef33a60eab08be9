// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/LumenField.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "lumen/SectionWall.h"
#include "lumen/TrustRadius.h"
#include "lumen/WallLines.h"
#include "numerics/CubicTable.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

constexpr double sectionStep_deg = 3.0;
constexpr int outlinePoints = WallLines::points;

}  // namespace

double LumenField::along(Column column, std::size_t section, const double weights[4]) const noexcept
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) sum += weights[k] * along_[section + k][column];
  return sum;
}

LumenField::LumenField(const ScalaTympani& scala) : entry_(scala.entry()), inward_W_(-entry_.out_W)
{
  lastAngle_ = scala.lastAngle().si();
  sections_ = static_cast<int>(std::lround(inDegrees(scala.lastAngle()) / sectionStep_deg)) + 1;
  const double step = lastAngle_ / (sections_ - 1);
  perSection_ = 1.0 / step;

  std::vector<double> radius, height, widths, heights, inner, outer, roof;
  for (int i = 0; i < sections_; ++i) {
    const double angle = step * i;
    const Eigen::Vector3d center = scala.center_W(angle);
    const SineCosine turn = sineCosine(angle);
    const SectionWall outline(scala, angle);
    double width = 0.0, tall = 0.0;
    for (const Direction& direction : directionsAround<outlinePoints>()) {
      const Eigen::Vector3d e = outline.at(direction) - center;
      width = std::max(width, std::fabs(e.x() * turn.cosine + e.y() * turn.sine));
      tall = std::max(tall, std::fabs(e.z()));
    }
    radius.push_back(center.x() * turn.cosine + center.y() * turn.sine);
    height.push_back(center.z());
    widths.push_back(width);
    heights.push_back(tall);
    const auto edge = [&](double fraction) {
      const Eigen::Vector3d e = scala.membrane_W(angle, fraction) - center;
      return e.x() * turn.cosine + e.y() * turn.sine;
    };
    inner.push_back(edge(0.0));
    outer.push_back(edge(1.0));
    roof.push_back((scala.membrane_W(angle, 0.5) - center).z());
  }
  along_.resize(static_cast<std::size_t>(sections_) + 2);
  const auto setColumn = [this](Column column, const std::vector<double>& samples) {
    const std::vector<double> coefficients = interpolatingCoefficients(samples);
    for (std::size_t i = 0; i < along_.size(); ++i) along_[i][column] = coefficients[i];
  };
  setColumn(centerRadius, radius);
  setColumn(centerHeight, height);
  setColumn(halfWidth, widths);
  setColumn(halfHeight, heights);
  setColumn(membraneInner, inner);
  setColumn(membraneOuter, outer);
  setColumn(membraneHeight, roof);

  minRadius_.resize(static_cast<std::size_t>(sections_));
  minSlant_.resize(static_cast<std::size_t>(sections_));
  distance_.resize((static_cast<std::size_t>(sections_) + 2) * page);
  for (int i = 0; i < sections_; ++i) fillSection(scala, i);
  continueIntoLeadIn();
  // beyond the last section: quadratic extrapolation of the last three
  float* last = distance_.data() + (static_cast<std::size_t>(sections_) + 1) * page;
  for (std::size_t k = 0; k < page; ++k)
    last[k] = 3.0f * ((last - page)[k] - (last - 2 * page)[k]) + (last - 3 * page)[k];

  std::vector<double> cellWidth, cellHeight;
  for (int i = -1; i <= sections_; ++i) {
    const auto section = static_cast<std::size_t>(std::clamp(i, 0, sections_ - 1));
    cellWidth.push_back(widths[section] / samplesPerUnit);
    cellHeight.push_back(heights[section] / samplesPerUnit);
  }
  trust_ = trustLevels(distance_, across, cellWidth, cellHeight);
}

// The page before the first section, chosen so that the derivative by the angle there equals that
// of the straight lead-in, along whose axis the distance is constant.
void LumenField::continueIntoLeadIn()
{
  const CubicWeights start(0.0);
  const auto slope = [&](Column column) { return along(column, 0, start.slope) * perSection_; };
  const double width = along(halfWidth, 0, start.value);
  const double tall = along(halfHeight, 0, start.value);
  const double radius = along(centerRadius, 0, start.value);
  float* before = distance_.data();
  const float* first = before + page;
  const auto difference = [](const float* row, int i, int step) {
    const int low = std::max(i - 1, 0), high = std::min(i + 1, across - 1);
    return static_cast<double>(row[high * step] - row[low * step]) * samplesPerUnit / (high - low);
  };
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j) {
      const double p = (i - 1) / samplesPerUnit - margin;
      const double q = (j - 1) / samplesPerUnit - margin;
      const double byP = difference(first + j, i, across);
      const double byQ = difference(first + i * across, j, 1);
      // The place (p, q) moves with the section; along the axis it would move by the tangent.
      const double perAngle = (radius + p * width) / inward_W_.y();
      const double moveU = slope(centerRadius) + p * slope(halfWidth) - perAngle * inward_W_.x();
      const double moveV = slope(centerHeight) + q * slope(halfHeight) - perAngle * inward_W_.z();
      const double byAngle = byP * moveU / width + byQ * moveV / tall;
      const int k = i * across + j;
      before[k] = static_cast<float>((first + page)[k] - 2.0 * byAngle / perSection_);
    }
}

// The distances of one section, from its outline and the wall's lengthwise direction.
void LumenField::fillSection(const ScalaTympani& scala, int section)
{
  const double angle = section / perSection_;
  const Eigen::Vector3d center = scala.center_W(angle);
  const WallLines lines(scala, angle);
  const auto row = static_cast<std::size_t>(section);
  minRadius_[row] = lines.minRadius();
  minSlant_[row] = lines.minSlant();

  // the last section is at the end of the last piece
  const std::size_t piece = std::min(row, static_cast<std::size_t>(sections_) - 2);
  const CubicWeights here(static_cast<double>(row - piece));
  const double width = along(halfWidth, piece, here.value);
  const double tall = along(halfHeight, piece, here.value);
  const SectionWall outline(scala, angle);
  const SectionWall::Radii radii = outline.radii();
  const std::vector<SectionWall::Radii> radiiOfSteps = outline.radiiOfSteps();
  constexpr double rounding = 1e-9;
  std::array<double, across> u{}, v{};
  for (int i = 0; i < across; ++i) {
    const double inHalves = (i - 1) / samplesPerUnit - margin;
    u[static_cast<std::size_t>(i)] = inHalves * width;
    v[static_cast<std::size_t>(i)] = inHalves * tall;
  }
  std::array<double, page> distances;
  lines.distances(u, v, distances.data());
  float* to = distance_.data() + (row + 1) * page;
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) {
      const double off = std::sqrt(u[i] * u[i] + v[j] * v[j]);
      bool isInside = off < (1.0 - rounding) * radii.min;
      if (!isInside && off < (1.0 + rounding) * radii.max) {
        const double direction = arcTangent(v[j], u[i]);
        const SectionWall::Radii& near = radiiOfSteps[outline.stepOf(direction)];
        isInside = off < (1.0 - rounding) * near.min;
        if (!isInside && off < (1.0 + rounding) * near.max) {
          const Eigen::Vector3d wall = outline.at(direction) - center;
          isInside =
              off < std::sqrt(wall.x() * wall.x() + wall.y() * wall.y() + wall.z() * wall.z());
        }
      }
      const double distance = distances[i * across + j];
      to[i * across + j] = static_cast<float>(isInside ? distance : -distance);
    }
}

}  // namespace perilymph::anatomy
