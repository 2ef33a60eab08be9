// SPDX-License-Identifier: BSD-3-Clause
#include "Cloud.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/SurfaceDistance.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::bench {
namespace {

constexpr std::size_t sizeOfCloud = 1000;

/// Random positions in the duct from a fixed seed.
class Places {
public:
  explicit Places(std::uint64_t seed) : draw_(seed) {}

  /// Uniform between two numbers. std::uniform_real_distribution differs between libraries.
  double between(double low, double high)
  {
    return low + (high - low) * static_cast<double>(draw_() >> 11U) * 0x1p-53;
  }
  /// From 20 degrees, behind the opening, to two thirds of the length, which arrays reach.
  double angle() { return between(pi / 9, meanScala().lastAngle().si() * 2.0 / 3.0); }
  double direction() { return between(0.0, 2.0 * pi); }

private:
  std::mt19937_64 draw_;
};

anatomy::LumenTrack trackAt(double angle)
{
  anatomy::LumenTrack track;
  track.inLeadIn = false;
  track.angle = angle;
  track.direction[0] = std::cos(angle);
  track.direction[1] = std::sin(angle);
  return track;
}

Cloud drawCloud()
{
  constexpr std::uint64_t seed = 2011;
  Places places(seed);
  Cloud drawn;
  while (drawn.centers_W.size() < sizeOfCloud) {
    const double angle = places.angle();
    const Eigen::Vector3d wall_W = meanScala().wall_W(angle, places.direction());
    const Eigen::Vector3d inward_W = (meanScala().center_W(angle) - wall_W).normalized();
    const Eigen::Vector3d center_W = wall_W + places.between(0.0, farthest) * inward_W;
    anatomy::LumenTrack track = trackAt(angle);
    anatomy::WallPoint wall;
    meanScala().nearestWall({&center_W, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
    if (!wall.isNear || wall.distance < 0.0 || wall.distance > farthest) continue;
    drawn.centers_W.push_back(center_W);
    drawn.tracks.push_back(track);
    drawn.distances.push_back(wall.distance);
  }
  return drawn;
}

Facets cut(int maxTriangles)
{
  const anatomy::Surface surface = anatomy::wallSurface(meanScala(), maxTriangles);
  Facets made{surface};
  for (auto& point : made.surface_mm.points)
    for (double& coordinate : point) coordinate *= 1e3;

  constexpr std::uint64_t seed = 1994;
  constexpr int tries = 4000;
  Places places(seed);
  const anatomy::SurfaceDistance triangles(surface);
  for (int i = 0; i < tries; ++i) {
    const double angle = places.angle();
    const Eigen::Vector3d wall_W = meanScala().wall_W(angle, places.direction());
    made.surfaceDistance = std::max(made.surfaceDistance, triangles.nearest(wall_W).distance);
  }
  return made;
}

}  // namespace

const Result<std::shared_ptr<const anatomy::ScalaTympani>>& builtMean()
{
  static const auto scala = anatomy::buildMean(millimeters(1));
  return scala;
}

const Cloud& cloud()
{
  static const Cloud drawn = drawCloud();
  return drawn;
}

const Facets& facets(int maxTriangles)
{
  static std::map<int, Facets> known;
  const auto found = known.find(maxTriangles);
  if (found != known.end()) return found->second;
  return known.emplace(maxTriangles, cut(maxTriangles)).first->second;
}

}  // namespace perilymph::bench
