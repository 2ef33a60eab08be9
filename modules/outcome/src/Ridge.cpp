// SPDX-License-Identifier: BSD-3-Clause
#include "Ridge.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

#include <Eigen/Geometry>

#include "perilymph/foundation/Math.h"

namespace perilymph::outcome {

namespace {

constexpr double brightPart = 0.10;  // of the typical brightness of the ridge: the array is there
constexpr double endPart = 0.25;     // the apical end is at least so bright
constexpr double sigma_mm = 0.2;     // of the picture in which the path is searched
constexpr double spacing_mm = 0.1;
constexpr double startBehind_mm = 2.5,
                 startBefore_mm = -1.0;  // past the opening, where the path starts
constexpr double maxTurned = 0.6;        // [rad] between neighboring cells
constexpr double radiusOfCentering_mm = 0.5;

/// Equal distances along a polyline.
std::vector<Eigen::Vector3d> resampled(const std::vector<Eigen::Vector3d>& points, double spacing)
{
  std::vector<Eigen::Vector3d> equal;
  if (points.empty()) return equal;
  equal.push_back(points.front());
  double need = spacing;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i] - points[i - 1]).norm();
    double gone = 0.0;
    while (length > 0.0 && gone + need <= length) {
      gone += need;
      equal.push_back(points[i - 1] + (gone / length) * (points[i] - points[i - 1]));
      need = spacing;
    }
    need -= length - gone;
  }
  return equal;
}

std::vector<Eigen::Vector3d> smoothed(const std::vector<Eigen::Vector3d>& points, int reach)
{
  std::vector<Eigen::Vector3d> result = points;
  const int count = static_cast<int>(points.size());
  for (int i = 0; i < count; ++i) {
    const int half = std::min({reach, i, count - 1 - i});
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int d = -half; d <= half; ++d) sum += points[static_cast<std::size_t>(i + d)];
    result[static_cast<std::size_t>(i)] = sum / (2 * half + 1);
  }
  return result;
}

/// Moves points to the centroid of the metal across the path.
void center(const MetalGrid& grid, std::vector<Eigen::Vector3d>& points)
{
  const std::vector<Eigen::Vector3d> before = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d along =
        (before[std::min(i + 2, before.size() - 1)] - before[i >= 2 ? i - 2 : 0]).normalized();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0.0;
    const int reach = static_cast<int>(std::ceil(radiusOfCentering_mm / grid.step_mm));
    for (int c = -reach; c <= reach; ++c)
      for (int b = -reach; b <= reach; ++b)
        for (int a = -reach; a <= reach; ++a) {
          Eigen::Vector3d off = grid.step_mm * Eigen::Vector3d(a, b, c);
          if (off.norm() > radiusOfCentering_mm || std::fabs(off.dot(along)) > 0.75 * grid.step_mm)
            continue;
          off -= off.dot(along) * along;
          const double value = grid.sample(grid.value, before[i] + off);
          sum += value * off;
          weight += value;
        }
    if (weight > 0.0) points[i] += sum / weight;
  }
}

}  // namespace

Eigen::Vector3d alongPolyline(const std::vector<Eigen::Vector3d>& points, double distance)
{
  if (points.empty()) return Eigen::Vector3d::Zero();
  if (points.size() == 1) return points.front();
  if (distance <= 0.0) return points.front() + distance * (points[1] - points[0]).normalized();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i] - points[i - 1]).norm();
    if (distance <= length && length > 0.0)
      return points[i - 1] + (distance / length) * (points[i] - points[i - 1]);
    distance -= length;
  }
  const std::size_t last = points.size() - 1;
  return points[last] + distance * (points[last] - points[last - 1]).normalized();
}

std::vector<Eigen::Vector3d> ridgeOf(const MetalGrid& grid, const EarFrame& frame)
{
  const std::vector<float> picture = blurred(grid, grid.value, sigma_mm);
  // typical brightness: of the brightest cells near the duct
  std::vector<EarPlace> places(picture.size());
  std::vector<char> isNear(picture.size(), 0);
  std::vector<float> bright;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::size_t cell = grid.index(i, j, k);
        if (picture[cell] <= 0.0F) continue;
        places[cell] = frame.placeOf(grid.at_P(i, j, k));
        isNear[cell] = places[cell].isNearDuct ? 1 : 0;
        if (isNear[cell] && places[cell].isInside) bright.push_back(picture[cell]);
      }
  if (bright.size() < 20) return {};
  const std::size_t typicalAt = bright.size() - 1 - std::min(bright.size() - 1, bright.size() / 20);
  std::nth_element(bright.begin(), bright.begin() + static_cast<std::ptrdiff_t>(typicalAt),
                   bright.end());
  const double typical = static_cast<double>(bright[typicalAt]);

  // minimal path from the opening
  std::vector<double> cost(picture.size(), 1e18);
  std::vector<std::size_t> from(picture.size(), 0);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t cell = 0; cell < picture.size(); ++cell)
    if (isNear[cell] && static_cast<double>(picture[cell]) > brightPart * typical &&
        places[cell].depth_mm > startBefore_mm && places[cell].depth_mm < startBehind_mm &&
        places[cell].angle < 0.6) {
      cost[cell] = 0.0;
      from[cell] = cell;
      queue.push({0.0, cell});
    }
  const auto stride = [&](int a, int b, int c) {
    return static_cast<std::ptrdiff_t>(a) +
           static_cast<std::ptrdiff_t>(grid.size[0]) *
               (static_cast<std::ptrdiff_t>(b) + static_cast<std::ptrdiff_t>(grid.size[1]) * c);
  };
  std::size_t end = picture.size();
  double deepest = -1e9;
  while (!queue.empty()) {
    const auto [spent, cell] = queue.top();
    queue.pop();
    if (spent > cost[cell]) continue;
    if (static_cast<double>(picture[cell]) > endPart * typical && places[cell].depth_mm > deepest) {
      deepest = places[cell].depth_mm;
      end = cell;
    }
    const int i = static_cast<int>(cell % static_cast<std::size_t>(grid.size[0]));
    const int j = static_cast<int>((cell / static_cast<std::size_t>(grid.size[0])) %
                                   static_cast<std::size_t>(grid.size[1]));
    const int k = static_cast<int>(
        cell / (static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1])));
    if (i < 1 || j < 1 || k < 1 || i + 1 >= grid.size[0] || j + 1 >= grid.size[1] ||
        k + 1 >= grid.size[2])
      continue;
    for (int c = -1; c <= 1; ++c)
      for (int b = -1; b <= 1; ++b)
        for (int a = -1; a <= 1; ++a) {
          if (a == 0 && b == 0 && c == 0) continue;
          const auto next =
              static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + stride(a, b, c));
          if (!isNear[next] || static_cast<double>(picture[next]) < brightPart * typical) continue;
          if (std::fabs(places[next].angle - places[cell].angle) > maxTurned) continue;
          const double part = std::min(1.0, static_cast<double>(picture[next]) / typical);
          const double step =
              grid.step_mm * std::sqrt(static_cast<double>(a * a + b * b + c * c)) / (part * part);
          if (spent + step >= cost[next]) continue;
          cost[next] = spent + step;
          from[next] = cell;
          queue.push({cost[next], next});
        }
  }
  if (end == picture.size()) return {};
  std::vector<Eigen::Vector3d> path;
  for (std::size_t cell = end;; cell = from[cell]) {
    const int i = static_cast<int>(cell % static_cast<std::size_t>(grid.size[0]));
    const int j = static_cast<int>((cell / static_cast<std::size_t>(grid.size[0])) %
                                   static_cast<std::size_t>(grid.size[1]));
    const int k = static_cast<int>(
        cell / (static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1])));
    path.push_back(grid.at_P(i, j, k));
    if (from[cell] == cell) break;
  }
  const int reach = static_cast<int>(std::lround(0.5 / spacing_mm));
  path = smoothed(resampled(path, spacing_mm), reach);
  for (int round = 0; round < 3; ++round) {
    center(grid, path);
    path = smoothed(resampled(smoothed(path, reach / 2), spacing_mm), 2);
  }
  return path;
}

std::vector<Eigen::Vector3d> followed(const MetalGrid& grid, const Eigen::Vector3d& from_P,
                                      const Eigen::Vector3d& direction_P, double distance_mm,
                                      int count)
{
  constexpr int samples = 6, directions = 12;
  constexpr double fullBrightness =
      2500.0;  // above bone or content: brighter metal attracts no more [intensity]
  constexpr double halved = 1.4;  // [rad]: a bend by which metal attracts half as much
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d from = from_P, along = direction_P.normalized();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d side = along.unitOrthogonal(), other = along.cross(side);
    Eigen::Vector3d best = along;
    double most = -1.0;
    for (const double bend : {0.0, 0.25, 0.5, 0.75, 1.0})
      for (int k = 0; k < (bend > 0.0 ? directions : 1); ++k) {
        const SineCosine turn = sineCosine(2.0 * pi * k / directions), lean = sineCosine(bend);
        const Eigen::Vector3d way =
            lean.cosine * along + lean.sine * (turn.cosine * side + turn.sine * other);
        double metal = 0.0;
        for (int n = 1; n <= samples; ++n)
          metal += std::min(grid.sample(grid.value, from + (n * distance_mm / samples) * way),
                            fullBrightness);
        metal *= 1.0 - bend * bend / (2.0 * halved * halved);
        if (metal > most) most = metal, best = way;
      }
    from += distance_mm * best;
    along = best;
    points.push_back(from);
  }
  return points;
}

}  // namespace perilymph::outcome
