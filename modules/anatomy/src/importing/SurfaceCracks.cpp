// SPDX-License-Identifier: BSD-3-Clause
#include "importing/SurfaceCracks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "importing/SurfaceRims.h"
#include "mesh/Triangles.h"

namespace perilymph::anatomy {
namespace {

// The thickness of a voxel; tears that are wider are refused (SurfaceRims.cpp).
constexpr double widest = 0.35e-3;
constexpr double ofToothedEdge = 0.25;
constexpr std::size_t fewTips = 2;  // more are the teeth of a rim

/// A corner of one triangle alone, and the corner that it may have been moved from.
struct Tip {
  int corner, home;
  bool isSure;  ///< Both free edges of the triangle lead to `home`.
  double gap;   ///< Distance of both corners [m].
  double edge;  ///< The shorter edge beside the gap [m].
  double rim;   ///< Length of rim that welding both leaves, less that of other choices [m].

  /// Closer to what the triangle was: both edges fit, or the gap is a rounding, or the rim is
  /// shorter.
  bool isLikelierThan(const Tip& other) const
  {
    return std::tuple(!isSure, !isClose(), rim) <
           std::tuple(!other.isSure, !other.isClose(), other.rim);
  }
  bool isClose() const { return gap <= ofToothedEdge * edge; }
};

double distance(const Surface& surface, int a, int b)
{
  return (corner(surface, a) - corner(surface, b)).norm();
}

/// Whether a line from a corner over the next goes on to a third within 78 degrees, as a rim does:
/// a tooth on a rim would be welded so, where a triangle of the wall turns back.
bool goesOn(const Surface& surface, int from, int over, int to)
{
  const Eigen::Vector3d first = corner(surface, over) - corner(surface, from);
  const Eigen::Vector3d second = corner(surface, to) - corner(surface, over);
  return first.dot(second) > 0.2 * first.norm() * second.norm();
}

std::vector<Tip> tipsOf(const Surface& surface)
{
  std::vector<int> triangles(surface.points.size(), 0), last(surface.points.size(), -1);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const int index : surface.triangles[i]) {
      ++triangles[static_cast<std::size_t>(index)];
      last[static_cast<std::size_t>(index)] = static_cast<int>(i);
    }
  if (std::find(triangles.begin(), triangles.end(), 1) == triangles.end()) return {};

  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      ++uses[{std::min(a, b), std::max(a, b)}];
    }
  std::multimap<int, int> freeEdges;
  for (const auto& [ends, count] : uses)
    if (count == 1) {
      freeEdges.emplace(ends.first, ends.second);
      freeEdges.emplace(ends.second, ends.first);
    }
  std::set<int> ends;
  for (const auto& edge : freeEdges) ends.insert(edge.first);

  std::vector<Tip> tips;
  for (const int tip : ends) {
    if (triangles[static_cast<std::size_t>(tip)] != 1) continue;
    const auto& own =
        surface.triangles[static_cast<std::size_t>(last[static_cast<std::size_t>(tip)])];
    std::optional<Tip> best;
    std::set<int> homes;
    for (const int beside : own) {
      if (beside == tip) continue;
      const auto [low, high] = freeEdges.equal_range(beside);
      for (auto edge = low; edge != high; ++edge) {
        const int home = edge->second;
        if (std::find(own.begin(), own.end(), home) != own.end()) continue;
        // a wall that is whole without this triangle
        const int other = own[0] + own[1] + own[2] - tip - beside;
        const auto across = uses.find({std::min(home, other), std::max(home, other)});
        if (across != uses.end() && across->second > 1) continue;
        const Tip found{tip,
                        home,
                        !homes.insert(home).second,
                        distance(surface, tip, home),
                        std::min(distance(surface, beside, tip), distance(surface, beside, home)),
                        distance(surface, other, home) - distance(surface, other, tip) -
                            distance(surface, beside, tip) - distance(surface, beside, home)};
        if (!found.isSure && goesOn(surface, other, beside, home)) continue;
        if (!best || found.isLikelierThan(*best)) best = found;
      }
    }
    if (best) tips.push_back(*best);
  }
  return tips;
}

enum class Kind { tooth, crack, tear };

Kind kindOf(const Tip& tip, std::size_t unsure)
{
  if (tip.isSure || unsure <= fewTips)
    return tip.gap <= std::max(widest, tip.edge) ? Kind::crack : Kind::tear;
  return tip.isClose() ? Kind::crack : Kind::tooth;
}

}  // namespace

Result<void> closeCracks(Surface& surface)
{
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    const std::vector<Tip> tips = tipsOf(surface);
    const auto unsure = static_cast<std::size_t>(
        std::count_if(tips.begin(), tips.end(), [](const Tip& tip) { return !tip.isSure; }));
    for (const Tip& tip : tips)
      if (kindOf(tip, unsure) == Kind::tear) return tornAt(surface, tip.corner, tip.gap);
    const bool anySure = unsure < tips.size();
    std::map<int, int> homes;
    std::set<int> used;
    for (const Tip& tip : tips) {
      if (tip.isSure != anySure || kindOf(tip, unsure) != Kind::crack) continue;
      if (!used.insert(tip.corner).second || !used.insert(tip.home).second) continue;
      homes[tip.corner] = tip.home;
    }
    for (auto& t : surface.triangles)
      for (int& index : t)
        if (const auto home = homes.find(index); home != homes.end()) {
          index = home->second;
          isChanged = true;
        }
  }
  return {};
}

}  // namespace perilymph::anatomy
