// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/SurfaceDeviation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "perilymph/anatomy/SurfaceDistance.h"

namespace perilymph::anatomy {
namespace {

constexpr int maxPieces = 64;  // maximum subdivisions of a triangle's side

struct Sample {
  double distance;  // [m]
  double weight;    // area it represents [m^2]
};

void sampleOneWay(const Surface& from, const SurfaceDistance& to, double spacing,
                  std::vector<Sample>& samples)
{
  for (const auto& t : from.triangles) {
    Eigen::Vector3d corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = from.points[static_cast<std::size_t>(t[k])];
      corners[k] = {p[0], p[1], p[2]};
    }
    const Eigen::Vector3d one = corners[1] - corners[0];
    const Eigen::Vector3d two = corners[2] - corners[0];
    const double longest = std::max({one.norm(), two.norm(), (two - one).norm()});
    const int pieces = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, maxPieces);
    const double places = 0.5 * (pieces + 1) * (pieces + 2);
    const double weight = 0.5 * one.cross(two).norm() / places;
    for (int i = 0; i <= pieces; ++i)
      for (int k = 0; i + k <= pieces; ++k) {
        const Eigen::Vector3d place = corners[0] + (one * i + two * k) / pieces;
        samples.push_back({to.nearest(place).distance, weight});
      }
  }
}

}  // namespace

SurfaceDeviation surfaceDistance(const Surface& one, const Surface& other, Length spacing)
{
  std::vector<Sample> samples;
  sampleOneWay(one, SurfaceDistance(other), spacing.si(), samples);
  sampleOneWay(other, SurfaceDistance(one), spacing.si(), samples);
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.distance < b.distance; });

  double whole = 0.0, sum = 0.0;
  for (const Sample& sample : samples) {
    whole += sample.weight;
    sum += sample.weight * sample.distance;
  }
  if (!(whole > 0.0)) return {};
  double below = 0.0, p95 = 0.0;
  for (const Sample& sample : samples) {
    below += sample.weight;
    p95 = sample.distance;
    if (below >= 0.95 * whole) break;
  }
  return {meters(sum / whole), meters(p95), meters(samples.back().distance)};
}

}  // namespace perilymph::anatomy
