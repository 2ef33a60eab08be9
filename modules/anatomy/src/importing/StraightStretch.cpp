// SPDX-License-Identifier: BSD-3-Clause
#include "importing/StraightStretch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/Triangles.h"
#include "numerics/DenseSolvers.h"

namespace perilymph::anatomy {
namespace {

constexpr double straight = 1e-3;     // sine of the angle between a wall and its direction
constexpr double straightRim = 1e-6;  // of RimFrame::scatter
constexpr double longest = 6e-3;      // a longer straight stretch is not a lead-in [m]

// Rings of corners, as on a surface swept along a duct. The wall between two rings is straight if
// they are parallel: if their planes differ by less than on a duct with a radius of curvature of 14
// mm, where a scala has 7 mm. The points of a ring deviate from its plane by less than a fifth of
// its distance from the previous one.
constexpr double parallel = 1.0 / 14e-3;  // [rad/m]
constexpr double flat = 0.2;

// A noisy stretch: tilts are averaged over this length of wall and are significant above four
// standard errors, or above this sine in any case. A scala curved from its rim on, with a radius of
// 7 mm, reaches it after 0.035 mm.
constexpr double bandLength = 0.2e-3;  // [m]
constexpr double standardErrors = 4.0;
constexpr double maxTilt = 5e-3;

bool touches(const std::array<int, 3>& triangle, const std::set<int>& corners)
{
  return std::any_of(triangle.begin(), triangle.end(),
                     [&](int index) { return corners.count(index) > 0; });
}

/// The wall's triangles, their neighbors, and the visited ones.
class WallWalk {
public:
  WallWalk(const ClosedSurface& closed, const RimFrame& rim)
      : surface_(closed.surface), isSeen_(closed.isLid.size(), false)
  {
    for (std::size_t i = 0; i < closed.isLid.size(); ++i) {
      if (closed.isLid[i]) continue;
      const auto& t = surface_.triangles[i];
      for (std::size_t k = 0; k < 3; ++k) edges_[edge(t, k)].push_back(static_cast<int>(i));
      if (touches(t, rim.corners)) push(static_cast<int>(i));
    }
  }

  bool isOver() const { return waiting_.empty(); }

  /// Removes the next triangle from the queue.
  int pop()
  {
    const int triangle = waiting_.back();
    waiting_.pop_back();
    return triangle;
  }

  void push(int triangle)
  {
    const auto index = static_cast<std::size_t>(triangle);
    if (isSeen_[index]) return;
    isSeen_[index] = true;
    waiting_.push_back(triangle);
  }

  void pushNeighbors(int triangle)
  {
    const auto& t = surface_.triangles[static_cast<std::size_t>(triangle)];
    for (std::size_t k = 0; k < 3; ++k)
      for (const int next : edges_.at(edge(t, k))) push(next);
  }

private:
  static std::pair<int, int> edge(const std::array<int, 3>& t, std::size_t k)
  {
    return {std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])};
  }

  const Surface& surface_;
  std::map<std::pair<int, int>, std::vector<int>> edges_;
  std::vector<bool> isSeen_;
  std::vector<int> waiting_;
};

/// A stretch without noise: depth of the first triangle that is not straight.
double exactStretch(const ClosedSurface& closed, const RimFrame& rim)
{
  const Surface& surface = closed.surface;
  WallWalk walk(closed, rim);
  double end = longest;
  while (!walk.isOver()) {
    const int triangle = walk.pop();
    const auto& t = surface.triangles[static_cast<std::size_t>(triangle)];
    const Eigen::Vector3d across = scaledNormal(surface, t);
    double minimum = 1e9;
    for (const int k : t) minimum = std::min(minimum, rim.depth(corner(surface, k)));
    if (std::fabs(across.dot(rim.inward)) > straight * across.norm()) {
      end = std::min(end, minimum);
      continue;
    }
    if (minimum <= end) walk.pushNeighbors(triangle);
  }
  return end < longest ? std::max(end, 0.0) : 0.0;
}

/// The best-fitting plane of a ring of corners, as depth = mean + tilt . position.
struct RingPlane {
  double depth = 0.0;                              ///< Mean over the ring [m].
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();  ///< [rad]
  double roughness = 0.0;                          ///< Root mean square distance from the plane
                                                   ///< [m].
};

RingPlane planeOf(const std::set<int>& ring, const Surface& surface, const RimFrame& rim)
{
  constexpr double lengthUnit = 1e-3;  // lengths near 1 keep the problem well conditioned
  const Eigen::Vector3d x = rim.inward.unitOrthogonal();
  const Eigen::Vector3d y = rim.inward.cross(x);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int index : ring) middle += corner(surface, index) / static_cast<double>(ring.size());
  const auto rowOf = [&](int index) -> std::vector<double> {
    const Eigen::Vector3d off = (corner(surface, index) - middle) / lengthUnit;
    return {1.0, off.dot(x), off.dot(y)};
  };
  LeastSquares fit(3);
  for (const int index : ring)
    fit.add(rowOf(index), rim.depth(corner(surface, index)) / lengthUnit);
  const std::vector<double> solution = fit.solve();
  RingPlane plane;
  plane.depth = lengthUnit * solution[0];
  plane.tilt = {solution[1], solution[2]};
  for (const int index : ring) {
    const std::vector<double> row = rowOf(index);
    const double off = rim.depth(corner(surface, index)) - plane.depth -
                       lengthUnit * (row[1] * solution[1] + row[2] * solution[2]);
    plane.roughness += off * off / static_cast<double>(ring.size());
  }
  plane.roughness = std::sqrt(plane.roughness);
  return plane;
}

/// Corners of the wall's triangles that touch the last ring, except those of earlier rings.
std::set<int> nextRing(const ClosedSurface& closed, const std::set<int>& last,
                       const std::set<int>& soFar)
{
  std::set<int> ring;
  for (std::size_t i = 0; i < closed.isLid.size(); ++i) {
    const auto& t = closed.surface.triangles[i];
    if (closed.isLid[i] || !touches(t, last)) continue;
    for (const int index : t)
      if (soFar.count(index) == 0) ring.insert(index);
  }
  return ring;
}

/// Planes of the rings behind a rim, as long as the corners form rings.
class Rings {
public:
  Rings(const ClosedSurface& closed, const RimFrame& rim)
      : closed_(closed), rim_(rim), last_(rim.corners), soFar_(rim.corners)
  {
    planes_.push_back(planeOf(last_, closed.surface, rim));
    planes_.front().depth = 0.0;
  }

  /// The plane of a ring, 0 for the rim; null if the corners form no further rings.
  const RingPlane* plane(std::size_t ring)
  {
    while (planes_.size() <= ring && !isOver_) {
      last_ = nextRing(closed_, last_, soFar_);
      soFar_.insert(last_.begin(), last_.end());
      const bool isRing = last_.size() >= 3;
      if (isRing) planes_.push_back(planeOf(last_, closed_.surface, rim_));
      isOver_ = !isRing || !isFlat();
    }
    return ring < planes_.size() - (isOver_ ? 1 : 0) ? &planes_[ring] : nullptr;
  }

private:
  bool isFlat() const
  {
    const double step = planes_.back().depth - planes_[planes_.size() - 2].depth;
    return planes_.back().roughness < flat * step;
  }

  const ClosedSurface& closed_;
  const RimFrame& rim_;
  std::set<int> last_, soFar_;
  std::deque<RingPlane> planes_;  ///< Grows while pointers to its elements are in use.
  bool isOver_ = false;
};

/// Straight stretch of a surface of rings: up to the last ring parallel to all before it. Empty if
/// the corners form no rings.
std::optional<double> stretchOfRings(const ClosedSurface& closed, const RimFrame& rim)
{
  Rings rings(closed, rim);
  Eigen::Vector2d tilts = Eigen::Vector2d::Zero();  // sum over the parallel rings
  const auto turnsAside = [&](const RingPlane& ring, const RingPlane& last, std::size_t count) {
    const double turn = (ring.tilt - tilts / static_cast<double>(count)).norm();
    return turn > parallel * (ring.depth - last.depth);
  };
  for (std::size_t i = 0; const RingPlane* const here = rings.plane(i); ++i) {
    tilts += here->tilt;
    const RingPlane* const next = rings.plane(i + 1);
    const RingPlane* const afterNext = rings.plane(i + 2);
    if (next == nullptr || afterNext == nullptr || here->depth > longest) return std::nullopt;
    // noise may tilt one ring, but hardly two
    if (turnsAside(*next, *here, i + 1) && turnsAside(*afterNext, *here, i + 1)) return here->depth;
  }
  return std::nullopt;
}

/// Inclination of a band of wall against the inward direction, n . inward = tilt . n + growth: a
/// band may bend aside and may widen.
struct MeanTilt {
  double depth = 0.0;  ///< Mean over the band [m].
  double sine = 0.0;   ///< Tilt and growth combined.
  double error = 0.0;  ///< Standard error of the sine.
};

MeanTilt leanOf(const std::vector<int>& band, const Surface& surface, const RimFrame& rim)
{
  const Eigen::Vector3d x = rim.inward.unitOrthogonal();
  const Eigen::Vector3d y = rim.inward.cross(x);
  LeastSquares fit(3);
  MeanTilt lean;
  double whole = 0.0;
  std::vector<std::pair<std::vector<double>, double>> rows;
  for (const int triangle : band) {
    const auto& t = surface.triangles[static_cast<std::size_t>(triangle)];
    const Eigen::Vector3d across = scaledNormal(surface, t);
    const double area = across.norm();
    if (!(area > 0.0)) continue;
    const Eigen::Vector3d n = across / area;
    const double weight = std::sqrt(area);
    rows.push_back({{weight * n.dot(x), weight * n.dot(y), weight}, weight * n.dot(rim.inward)});
    fit.add(rows.back().first, rows.back().second);
    const Eigen::Vector3d middle =
        (corner(surface, t[0]) + corner(surface, t[1]) + corner(surface, t[2])) / 3.0;
    lean.depth += area * rim.depth(middle);
    whole += area;
  }
  const std::vector<double> solution = fit.solve();
  double rest = 0.0;
  for (const auto& [row, right] : rows) {
    const double off = row[0] * solution[0] + row[1] * solution[1] + row[2] * solution[2] - right;
    rest += off * off;
  }
  lean.depth /= whole;
  lean.sine =
      std::sqrt(solution[0] * solution[0] + solution[1] * solution[1] + solution[2] * solution[2]);
  lean.error = std::sqrt(rest / whole / static_cast<double>(rows.size()));
  return lean;
}

/// A stretch with noise: adds bands until one is inclined.
double noisyStretch(const ClosedSurface& closed, const RimFrame& rim)
{
  WallWalk walk(closed, rim);
  std::vector<int> beyond, band;
  std::optional<MeanTilt> first, last;
  for (int i = 1; i * bandLength < longest; ++i) {
    for (const int triangle : std::exchange(beyond, {})) band.push_back(triangle);
    std::vector<int> inBand;
    const auto sort = [&](int triangle) {
      const auto& t = closed.surface.triangles[static_cast<std::size_t>(triangle)];
      double depth = 0.0;
      for (const int k : t) depth += rim.depth(corner(closed.surface, k)) / 3.0;
      if (depth > i * bandLength) return beyond.push_back(triangle);
      inBand.push_back(triangle);
      walk.pushNeighbors(triangle);
    };
    for (const int triangle : std::exchange(band, {})) sort(triangle);
    while (!walk.isOver()) sort(walk.pop());
    if (inBand.size() < 3) continue;

    const MeanTilt here = leanOf(inBand, closed.surface, rim);
    if (!first) first = here;
    const double noise = std::sqrt(first->error * first->error + here.error * here.error);
    const double allowed = std::clamp(standardErrors * noise, straight, maxTilt);
    if (here.sine > allowed) {
      if (!last) return 0.0;
      const double fraction = (allowed - last->sine) / (here.sine - last->sine);
      const double end = last->depth + std::clamp(fraction, 0.0, 1.0) * (here.depth - last->depth);
      // the inward direction is that of the first band
      return std::max(end - first->depth, 0.0);
    }
    last = here;
  }
  return 0.0;
}

}  // namespace

double straightStretch(const ClosedSurface& closed, const RimFrame& rim)
{
  if (const auto rings = stretchOfRings(closed, rim)) return *rings;
  const double exact = rim.scatter <= straightRim ? exactStretch(closed, rim) : 0.0;
  return exact > 0.0 ? exact : noisyStretch(closed, rim);
}

}  // namespace perilymph::anatomy
