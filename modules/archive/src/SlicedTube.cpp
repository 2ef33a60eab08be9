// SPDX-License-Identifier: BSD-3-Clause
#include "SlicedTube.h"

#include <algorithm>
#include <cmath>

namespace perilymph::archive {

namespace {

using Point = std::array<double, 3>;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A point of the surface in the slice: column, row, and height above it [mm].
struct Placed {
  double column, row, height;
};

Placed placed(const SlicePlane& slice, const Point& normal, const Point& point)
{
  Point from{};
  for (std::size_t i = 0; i < 3; ++i) from[i] = point[i] - slice.origin[i];
  return {dot(from, slice.acrossStep) / dot(slice.acrossStep, slice.acrossStep),
          dot(from, slice.downStep) / dot(slice.downStep, slice.downStep), dot(from, normal)};
}

/// Where an edge meets the slice. Both triangles of an edge get the same bits, so that no gap opens.
Placed meeting(const std::vector<Placed>& points, std::size_t one, std::size_t other)
{
  const Placed& a = points[std::min(one, other)];
  const Placed& b = points[std::max(one, other)];
  const double t = a.height / (a.height - b.height);
  return {a.column + t * (b.column - a.column), a.row + t * (b.row - a.row), 0.0};
}

}  // namespace

SlicedTube::SlicedTube(const std::vector<Point>& points_mm, std::size_t pointsPerRing)
    : points_mm_(points_mm)
{
  const std::size_t n = pointsPerRing, rings = points_mm.size() / n;
  for (std::size_t ring = 0; ring + 1 < rings; ++ring)
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t a = ring * n + k, b = ring * n + (k + 1) % n;
      triangles_.push_back({a, b, a + n});
      triangles_.push_back({b, b + n, a + n});
    }
  for (const std::size_t ring : {std::size_t{0}, rings - 1}) {
    Point middle{};
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        middle[i] += points_mm[ring * n + k][i] / static_cast<double>(n);
    const std::size_t center = points_mm_.size();
    points_mm_.push_back(middle);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t a = ring * n + k, b = ring * n + (k + 1) % n;
      if (ring == 0)
        triangles_.push_back({b, a, center});
      else
        triangles_.push_back({a, b, center});
    }
  }
}

std::vector<std::uint8_t> SlicedTube::inside(const SlicePlane& slice) const
{
  const auto rows = static_cast<std::size_t>(slice.rows);
  const auto columns = static_cast<std::size_t>(slice.columns);
  const Point normal = cross(slice.acrossStep, slice.downStep);
  std::vector<Placed> points;
  points.reserve(points_mm_.size());
  for (const Point& point : points_mm_) points.push_back(placed(slice, normal, point));

  // how often the surface winds around a center: crossings of its row to the left, by direction
  std::vector<int> crossings(rows * (columns + 1));
  bool isMet = false;
  for (const auto& corners : triangles_) {
    const auto isAbove = [&](std::size_t k) { return points[corners[k]].height >= 0.0; };
    const int above = int(isAbove(0)) + int(isAbove(1)) + int(isAbove(2));
    if (above == 0 || above == 3) continue;
    // the corner that is alone on its side, then the other two in the triangle's sense
    std::size_t alone = 0;
    while (isAbove(alone) != (above == 1)) ++alone;
    const std::size_t tip = corners[alone], next = corners[(alone + 1) % 3],
                      last = corners[(alone + 2) % 3];
    Placed from = meeting(points, tip, next), to = meeting(points, tip, last);
    if (above == 2) std::swap(from, to);
    const int sign = to.row > from.row ? 1 : -1;
    const double low = std::min(from.row, to.row), high = std::max(from.row, to.row);
    const double first = std::max(0.0, std::ceil(low));
    for (double row = first; row < high && row < slice.rows; row += 1.0) {
      const double column =
          from.column + (row - from.row) / (to.row - from.row) * (to.column - from.column);
      const double behind = std::clamp(std::ceil(column), 0.0, double(slice.columns));
      crossings[static_cast<std::size_t>(row) * (columns + 1) + static_cast<std::size_t>(behind)] +=
          sign;
      isMet = true;
    }
  }
  if (!isMet) return {};
  std::vector<std::uint8_t> pixels(rows * columns);
  bool isAny = false;
  for (std::size_t row = 0; row < rows; ++row) {
    int winding = 0;
    for (std::size_t column = 0; column < columns; ++column) {
      winding += crossings[row * (columns + 1) + column];
      pixels[row * columns + column] = winding != 0 ? 1 : 0;
      isAny = isAny || winding != 0;
    }
  }
  if (!isAny) pixels.clear();
  return pixels;
}

}  // namespace perilymph::archive
