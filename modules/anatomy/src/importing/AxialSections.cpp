// SPDX-License-Identifier: BSD-3-Clause
#include "importing/AxialSections.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {
namespace {

constexpr double stride_deg = 3.0;
constexpr double endPrecision_deg = 0.05;
constexpr double farthestStep = 0.45e-3;  // maximum distance of the centers of successive cuts [m]
constexpr double maxTracedTurns = 4.0;
constexpr double minArea = 0.05e-6;  // a smaller cut is not the duct [m^2]
// Maximum relative change of the area between successive sections of the same duct.
constexpr double likeness = 0.55;

struct Cut {
  double r, z;
};

/// The part of a closed line on the near side of the axis: at the apex a duct may reach across a
/// slightly misplaced axis.
std::vector<Cut> clipped(const std::vector<Cut>& line)
{
  std::vector<Cut> kept;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Cut& a = line[k];
    const Cut& b = line[(k + 1) % line.size()];
    if (a.r >= 0.0) kept.push_back(a);
    if ((a.r >= 0.0) != (b.r >= 0.0)) kept.push_back({0.0, a.z + a.r / (a.r - b.r) * (b.z - a.z)});
  }
  return kept;
}

/// Measures of the area enclosed by a closed line, by the divergence theorem.
AxialSection measured(const std::vector<Cut>& line, double angle)
{
  AxialSection section;
  section.angle = angle;
  section.innerRadius = section.floorHeight = 1e9;
  section.outerRadius = section.roofHeight = -1e9;
  double twice = 0.0, byR = 0.0, byZ = 0.0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Cut& a = line[k];
    const Cut& b = line[(k + 1) % line.size()];
    const double cross = a.r * b.z - b.r * a.z;
    twice += cross;
    byR += cross * (a.r + b.r);
    byZ += cross * (a.z + b.z);
    section.innerRadius = std::min(section.innerRadius, a.r);
    section.outerRadius = std::max(section.outerRadius, a.r);
    section.floorHeight = std::min(section.floorHeight, a.z);
    section.roofHeight = std::max(section.roofHeight, a.z);
  }
  section.area = 0.5 * std::fabs(twice);
  if (twice != 0.0) {
    section.centerRadius = byR / (3.0 * twice);
    section.centerHeight = byZ / (3.0 * twice);
  }
  return section;
}

/// The section at an angle that continues the previous one.
std::optional<AxialSection> next(const Surface& closed, const AxisFrame& frame,
                                 const AxialSection& before, double angle)
{
  std::optional<AxialSection> best;
  double smallest = farthestStep;
  for (const AxialSection& one : sectionsAt(closed, frame, angle)) {
    const double out = one.centerRadius - before.centerRadius;
    const double up = one.centerHeight - before.centerHeight;
    const double off = std::sqrt(out * out + up * up);
    const bool isLike = one.area > likeness * before.area && before.area > likeness * one.area;
    if (off > smallest || !isLike) continue;
    smallest = off;
    best = one;
  }
  return best;
}

/// Follows the duct in one direction; the last section is at its end.
std::vector<AxialSection> followOneWay(const Surface& closed, const AxisFrame& frame,
                                       const AxialSection& seed, double stride)
{
  std::vector<AxialSection> sections{seed};
  while (std::fabs(sections.back().angle - seed.angle) < maxTracedTurns * 2.0 * pi) {
    const auto found = next(closed, frame, sections.back(), sections.back().angle + stride);
    if (!found) break;
    sections.push_back(*found);
  }
  const double precision = degrees(endPrecision_deg).si();
  for (double step = 0.5 * stride; std::fabs(step) > precision; step *= 0.5)
    if (const auto found = next(closed, frame, sections.back(), sections.back().angle + step))
      sections.push_back(*found);
  return sections;
}

}  // namespace

std::vector<AxialSection> sectionsAt(const Surface& closed, const AxisFrame& frame, double angle)
{
  const SineCosine turn = sineCosine(angle);
  const Eigen::Vector3d across = frame.axes * Eigen::Vector3d(-turn.sine, turn.cosine, 0.0);
  const Eigen::Vector3d outward = frame.axes * Eigen::Vector3d(turn.cosine, turn.sine, 0.0);
  const Eigen::Vector3d up = frame.axes.col(2);

  std::vector<double> side(closed.points.size());
  std::vector<Cut> place(closed.points.size());
  for (std::size_t i = 0; i < closed.points.size(); ++i) {
    const auto& p = closed.points[i];
    const Eigen::Vector3d e = Eigen::Vector3d(p[0], p[1], p[2]) - frame.origin;
    const double off = e.dot(across);
    side[i] = off >= 0.0 ? std::max(off, 1e-12) : off;  // no corner may lie in the plane
    place[i] = {e.dot(outward), e.dot(up)};
  }
  // each triangle connects one crossed edge to another
  using Edge = std::pair<int, int>;
  std::multimap<Edge, Edge> leads;
  for (const auto& t : closed.triangles) {
    std::array<Edge, 2> crossed;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3 && count < 2; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if ((side[static_cast<std::size_t>(a)] > 0.0) != (side[static_cast<std::size_t>(b)] > 0.0))
        crossed[count++] = {std::min(a, b), std::max(a, b)};
    }
    if (count < 2) continue;
    leads.emplace(crossed[0], crossed[1]);
    leads.emplace(crossed[1], crossed[0]);
  }
  const auto crossing = [&](const Edge& edge) -> Cut {
    const auto a = static_cast<std::size_t>(edge.first), b = static_cast<std::size_t>(edge.second);
    const double fraction = side[a] / (side[a] - side[b]);
    return {place[a].r + fraction * (place[b].r - place[a].r),
            place[a].z + fraction * (place[b].z - place[a].z)};
  };

  std::vector<AxialSection> sections;
  while (!leads.empty()) {
    std::vector<Cut> line;
    Edge here = leads.begin()->first;
    for (auto step = leads.begin(); step != leads.end(); step = leads.find(here)) {
      const Edge to = step->second;
      leads.erase(step);
      // the same segment, in the opposite direction
      const auto [low, high] = leads.equal_range(to);
      for (auto back = low; back != high; ++back)
        if (back->second == here) {
          leads.erase(back);
          break;
        }
      line.push_back(crossing(here));
      here = to;
    }
    const std::vector<Cut> near = clipped(line);
    const AxialSection section = measured(near, angle);
    if (near.size() > 2 && section.centerRadius > 0.0 && section.area > minArea)
      sections.push_back(section);
  }
  return sections;
}

std::vector<AxialSection> followDuct(const Surface& closed, const AxisFrame& frame)
{
  // start in the first turn: at the angle where the maximum radius of all lines is smallest
  constexpr int tries = 24;
  std::optional<AxialSection> seed;
  for (int i = 0; i < tries; ++i) {
    std::optional<AxialSection> outermost;
    for (const AxialSection& one : sectionsAt(closed, frame, 2.0 * pi * i / tries))
      if (!outermost || one.outerRadius > outermost->outerRadius) outermost = one;
    if (outermost && (!seed || outermost->outerRadius < seed->outerRadius)) seed = outermost;
  }
  if (!seed) return {};

  const double stride = degrees(stride_deg).si();
  std::vector<AxialSection> sections = followOneWay(closed, frame, *seed, -stride);
  std::reverse(sections.begin(), sections.end());
  const std::vector<AxialSection> apical = followOneWay(closed, frame, *seed, stride);
  sections.insert(sections.end(), apical.begin() + 1, apical.end());
  return sections;
}

}  // namespace perilymph::anatomy
