// SPDX-License-Identifier: BSD-3-Clause
#include "MeanLumen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "Pieces.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

constexpr double lineStep = 2.0 * pi / 180.0;   // between entries of the tables of lines [rad]
constexpr double fieldStep = 7.5 * pi / 180.0;  // between sections of the distance field [rad]
constexpr double cell = 0.08;                   // of the distance field [mm]
constexpr double uLow = -3.3, vLow = -2.0;      // its corner [mm]
constexpr int uCount = 56, vCount = 51;
constexpr double apex_deg = 900.0, cap_deg = 50.0;  // as in the mean anatomy of the module anatomy
constexpr int corners = 96;

struct Point {
  double r, z;
};
using Polygon = std::vector<Point>;
constexpr std::size_t coefficients = 2 * anatomy::MeasuredSection::harmonics + 1;

/// Fourier coefficients of the outline at an angle: Catmull-Rom between the measured sections,
/// linear before the first, extrapolated by the trend of the last turn.
class Outlines {
public:
  explicit Outlines(const std::vector<anatomy::MeasuredSection>& sections) : sections_(sections)
  {
    const auto& last = sections.back();
    const auto before = std::find_if(sections.begin(), sections.end(), [&](const auto& each) {
      return each.angle >= last.angle - 2.0 * pi - 1e-6;
    });
    const double turn = last.angle - before->angle;
    shrinking_ = logarithm(before->outerRadius / last.outerRadius) / turn;
    rise_ = (last.imaginary[center] - before->imaginary[center]) / turn;
  }

  Polygon at(double angle) const
  {
    std::array<double, coefficients> real{}, imaginary{};
    const auto& last = sections_.back();
    if (angle >= last.angle) {
      const double size = exponential(-shrinking_ * (angle - last.angle));
      for (std::size_t k = 0; k < coefficients; ++k) {
        real[k] = size * last.real[k];
        imaginary[k] = k == center ? last.imaginary[k] + rise_ * (1.0 - size) / shrinking_
                                   : size * last.imaginary[k];
      }
    } else {
      std::size_t i = 0;
      while (i + 2 < sections_.size() && sections_[i + 1].angle <= angle) ++i;
      const double t = (angle - sections_[i].angle) / (sections_[i + 1].angle - sections_[i].angle);
      for (std::size_t k = 0; k < coefficients; ++k) {
        real[k] = between(i, t, [k](const auto& section) { return section.real[k]; });
        imaginary[k] = between(i, t, [k](const auto& section) { return section.imaginary[k]; });
      }
    }
    // A rounded cap at the apex.
    const double past = (angle - degrees(apex_deg - cap_deg).si()) / degrees(cap_deg).si();
    const double x = 0.95 * std::clamp(past, 0.0, 1.0);
    const double fraction = std::sqrt(1.0 - x * x);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
      Point point{real[center], imaginary[center]};
      for (int k = -anatomy::MeasuredSection::harmonics; k <= anatomy::MeasuredSection::harmonics;
           ++k) {
        if (k == 0) continue;
        const SineCosine turn = sineCosine(2.0 * pi * k * i / corners);
        const auto index = static_cast<std::size_t>(k + anatomy::MeasuredSection::harmonics);
        point.r += fraction * (real[index] * turn.cosine - imaginary[index] * turn.sine);
        point.z += fraction * (imaginary[index] * turn.cosine + real[index] * turn.sine);
      }
      polygon.push_back({1e3 * point.r, 1e3 * point.z});
    }
    return polygon;
  }

private:
  static constexpr std::size_t center = anatomy::MeasuredSection::harmonics;

  template <class Value>
  double between(std::size_t i, double t, Value value) const
  {
    const double b = value(sections_[i]), c = value(sections_[i + 1]);
    if (t < 0.0) return b + t * (c - b);
    const double a = i > 0 ? value(sections_[i - 1]) : 2.0 * b - c;
    const double d = i + 2 < sections_.size() ? value(sections_[i + 2]) : 2.0 * c - b;
    return b +
           0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
  }

  const std::vector<anatomy::MeasuredSection>& sections_;
  double shrinking_ = 0.0, rise_ = 0.0;
};

double cross(const Point& o, const Point& a, const Point& b)
{
  return (a.r - o.r) * (b.z - o.z) - (a.z - o.z) * (b.r - o.r);
}

/// The convex hull, counter-clockwise (Andrew's monotone chain).
Polygon hull(Polygon points)
{
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.r < b.r || (a.r == b.r && a.z < b.z); });
  Polygon chain(2 * points.size());
  std::size_t count = 0;
  for (const Point& point : points) {
    while (count >= 2 && cross(chain[count - 2], chain[count - 1], point) <= 0.0) --count;
    chain[count++] = point;
  }
  const std::size_t lower = count + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) {
    while (count >= lower && cross(chain[count - 2], chain[count - 1], points[i]) <= 0.0) --count;
    chain[count++] = points[i];
  }
  chain.resize(count - 1);
  return chain;
}

/// Union of the scala tympani's outline and its mirror image in its roof.
Polygon joined(Polygon tympani)
{
  double roof = tympani.front().z;
  for (const Point& point : tympani) roof = std::max(roof, point.z);
  const std::size_t count = tympani.size();
  for (std::size_t i = 0; i < count; ++i)
    tympani.push_back({tympani[i].r, 2.0 * roof - tympani[i].z});
  return hull(std::move(tympani));
}

/// Distance to a convex polygon, positive inside.
double distanceTo(const Polygon& polygon, const Point& p)
{
  double minimum = std::numeric_limits<double>::max();
  bool isInside = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double dr = b.r - a.r, dz = b.z - a.z;
    const double length2 = dr * dr + dz * dz;
    if (length2 <= 0.0) continue;
    const double t = std::clamp(((p.r - a.r) * dr + (p.z - a.z) * dz) / length2, 0.0, 1.0);
    const double er = p.r - a.r - t * dr, ez = p.z - a.z - t * dz;
    minimum = std::min(minimum, er * er + ez * ez);
    if (cross(a, b, p) < 0.0) isInside = false;
  }
  return isInside ? std::sqrt(minimum) : -std::sqrt(minimum);
}

struct Box {
  double left, right, low, high;
};

Box boxOf(const Polygon& polygon)
{
  Box box{polygon.front().r, polygon.front().r, polygon.front().z, polygon.front().z};
  for (const Point& p : polygon)
    box = {std::min(box.left, p.r), std::max(box.right, p.r), std::min(box.low, p.z),
           std::max(box.high, p.z)};
  return box;
}

}  // namespace

Result<MeanLumen> MeanLumen::make()
{
  const auto sections = anatomy::loadMeasuredSections();
  if (!sections) return sections.error();
  const Outlines outlines(*sections);
  MeanLumen mean;
  mean.lastAngle_ = degrees(apex_deg).si();
  std::vector<double> lines, fields;
  for (int i = 0; firstAngle() + (i - 1) * lineStep <= mean.lastAngle_; ++i)
    lines.push_back(firstAngle() + i * lineStep);
  for (int i = 0; firstAngle() + (i - 1) * fieldStep <= mean.lastAngle_; ++i)
    fields.push_back(firstAngle() + i * fieldStep);
  for (std::vector<double>* each : {&mean.outer_, &mean.height_, &mean.width_, &mean.halfHeight_})
    each->resize(lines.size());
  eachPiece(lines.size(), Threads::all, [&](std::size_t i) {
    const Box box = boxOf(joined(outlines.at(lines[i])));
    mean.outer_[i] = box.right;
    mean.height_[i] = 0.5 * (box.low + box.high);
    mean.width_[i] = box.right - box.left;
    mean.halfHeight_[i] = 0.5 * (box.high - box.low);
  });
  constexpr std::size_t page = std::size_t{uCount} * vCount;
  mean.angles_ = static_cast<int>(fields.size());
  mean.field_.resize(fields.size() * page);
  eachPiece(fields.size(), Threads::all, [&](std::size_t i) {
    const Polygon polygon = joined(outlines.at(fields[i]));
    const Box box = boxOf(polygon);
    float* to = mean.field_.data() + i * page;
    for (int v = 0; v < vCount; ++v)
      for (int u = 0; u < uCount; ++u)
        *to++ = static_cast<float>(distanceTo(
            polygon, {box.right + uLow + u * cell, 0.5 * (box.low + box.high) + vLow + v * cell}));
  });
  return mean;
}

LinePlace MeanLumen::placeOf(double angle) const
{
  const double x = std::max(0.0, (angle - firstAngle()) / lineStep);
  const auto first = std::min(static_cast<std::size_t>(x), outer_.size() - 2);
  return {first, std::min(1.0, x - static_cast<double>(first))};
}

double MeanLumen::slope(const std::vector<double>& table, double angle) const
{
  return (at(table, angle + lineStep) - at(table, angle - lineStep)) / (2.0 * lineStep);
}

SectionDistance MeanLumen::distance(double angle, double u, double v) const
{
  const double x = std::clamp((u - uLow) / cell, 0.0, uCount - 1.001);
  const double y = std::clamp((v - vLow) / cell, 0.0, vCount - 1.001);
  const double s = std::clamp((angle - firstAngle()) / fieldStep, 0.0, angles_ - 1.001);
  const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y),
             k = static_cast<std::size_t>(s);
  const double fx = x - static_cast<double>(i), fy = y - static_cast<double>(j),
               fs = s - static_cast<double>(k);
  constexpr std::size_t row = uCount, plane = row * vCount;
  const float* base = field_.data() + k * plane + j * row + i;
  const auto mix = [&](std::size_t offset) {
    return (1.0 - fs) * static_cast<double>(base[offset]) +
           fs * static_cast<double>(base[offset + plane]);
  };
  const double a = mix(0), b = mix(1), c = mix(row), d = mix(row + 1);
  SectionDistance result{};
  result.inside = (1.0 - fy) * ((1.0 - fx) * a + fx * b) + fy * ((1.0 - fx) * c + fx * d);
  result.du = ((1.0 - fy) * (b - a) + fy * (d - c)) / cell;
  result.dv = ((1.0 - fx) * (c - a) + fx * (d - b)) / cell;
  // Beyond the tables the distance increases by the clipped part.
  const double beyondU = u - (uLow + x * cell), beyondV = v - (vLow + y * cell);
  if (beyondU != 0.0 || beyondV != 0.0)
    result.inside -= std::sqrt(beyondU * beyondU + beyondV * beyondV);
  return result;
}

}  // namespace perilymph::ct
