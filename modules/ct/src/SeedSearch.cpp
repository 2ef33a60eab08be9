// SPDX-License-Identifier: BSD-3-Clause
#include "SeedSearch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Padding.h"
#include "Pieces.h"

namespace perilymph::ct {
namespace {

constexpr double seedStep_mm = 4.0;
constexpr double sphere_mm = 4.5, sphereStep_mm = 1.3;
constexpr double bothSides_mm = 100.0;  // the center of a volume this wide is the head's

}  // namespace

std::optional<double> midline_P(const CtVolume& volume)
{
  double low = 1e9, high = -1e9;
  for (int corner = 0; corner < 8; ++corner) {
    const std::array<int, 3>& size = volume.size();
    const double x = volume
                         .toLps({(corner & 1) != 0 ? size[0] - 1.0 : 0.0,
                                 (corner & 2) != 0 ? size[1] - 1.0 : 0.0,
                                 (corner & 4) != 0 ? size[2] - 1.0 : 0.0})
                         .x();
    low = std::min(low, x);
    high = std::max(high, x);
  }
  if (high - low < bothSides_mm) return std::nullopt;
  return 0.5 * (low + high);
}

std::vector<Eigen::Vector3d> findSeeds(const CtVolume& volume,
                                       const std::optional<Eigen::Vector3d>& elsewhere_P,
                                       std::size_t count)
{
  // Dense bone is defined by the volume's own 99th percentile: levels are not fixed.
  const double bright = quantile(volume, 0.99), dark = quantile(volume, 0.02);
  const double dense = dark + 0.8 * (bright - dark), hollow = dark + 0.55 * (bright - dark);
  std::vector<Eigen::Vector3d> sphere;
  const int reach = static_cast<int>(sphere_mm / sphereStep_mm);
  for (int k = -reach; k <= reach; ++k)
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) {
        const Eigen::Vector3d offset = sphereStep_mm * Eigen::Vector3d(i, j, k);
        if (offset.norm() <= sphere_mm) sphere.push_back(offset);
      }
  const Eigen::Vector3d spacing = volume.spacing_mm();
  const Eigen::Vector3d step = Eigen::Vector3d::Constant(seedStep_mm).cwiseQuotient(spacing);
  struct Scored {
    double score;
    Eigen::Vector3d place_P;
  };
  std::vector<double> levels;
  for (double k = 0.5 * step.z(); k < volume.size()[2]; k += step.z()) levels.push_back(k);
  std::vector<std::vector<Scored>> inLevel(levels.size());
  const auto score = [&](std::size_t level) {
    for (double j = 0.5 * step.y(); j < volume.size()[1]; j += step.y())
      for (double i = 0.5 * step.x(); i < volume.size()[0]; i += step.x()) {
        const Eigen::Vector3d place_P = volume.toLps({i, j, levels[level]});
        if (elsewhere_P && (place_P - *elsewhere_P).norm() < anotherEar_mm) continue;
        int known = 0, bone = 0, hole = 0;
        for (const Eigen::Vector3d& offset : sphere)
          if (const auto value = volume.sample(place_P + offset)) {
            ++known;
            if (*value > dense) ++bone;
            if (*value < hollow) ++hole;
          }
        if (known * 2 < static_cast<int>(sphere.size())) continue;
        const double boneFraction = static_cast<double>(bone) / known;
        const double holeFraction = static_cast<double>(hole) / known;
        // A third of the sphere around a cochlea's center is lumen and canal.
        inLevel[level].push_back({boneFraction - 2.0 * std::fabs(holeFraction - 0.33), place_P});
      }
  };
  eachPiece(levels.size(), Threads::all, score);
  std::vector<Scored> scored;
  for (const std::vector<Scored>& each : inLevel)
    scored.insert(scored.end(), each.begin(), each.end());
  std::stable_sort(scored.begin(), scored.end(),
                   [](const Scored& a, const Scored& b) { return a.score > b.score; });
  std::vector<Eigen::Vector3d> seeds;
  for (std::size_t i = 0; i < scored.size() && i < count; ++i) seeds.push_back(scored[i].place_P);
  return seeds;
}

}  // namespace perilymph::ct
