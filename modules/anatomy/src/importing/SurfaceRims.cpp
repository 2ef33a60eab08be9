// SPDX-License-Identifier: BSD-3-Clause
#include "importing/SurfaceRims.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "importing/NumberText.h"
#include "mesh/Triangles.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

// Cracks up to 0.3 mm change no measure: their fans lie within the wall's thickness of a voxel.
constexpr double harmlessCrack = 0.35e-3;
constexpr double tornEdges = 2.0;  // of the longest edge beside the corner
// A circle has circularity 1, an ellipse of 3 to 1 has 0.55; a slit has near 0.
constexpr double minCircularity = 0.25;
// The wall around an opening runs across its plane, 0 for a straight cut and 0.55 for one at 60
// degrees; that around a hole in its side lies in the plane, 1 for a small hole.
constexpr double maxInPlane = 0.75;

using Edge = std::pair<int, int>;

/// The triangles at each corner of a rim.
using Fans = std::map<int, std::vector<std::array<int, 3>>>;

Fans fansOf(const Surface& surface, const std::vector<SurfaceRim>& rims)
{
  Fans fans;
  for (const SurfaceRim& rim : rims)
    for (const int index : rim.corners) fans[index];
  for (const auto& triangle : surface.triangles)
    for (const int index : triangle)
      if (const auto found = fans.find(index); found != fans.end())
        found->second.push_back(triangle);
  return fans;
}

/// The longest edge of the triangles at a rim's corners that do not touch one of them.
double longestEdgeBeside(const Surface& surface, const SurfaceRim& rim, const Fans& fans, int torn)
{
  double longestEdge = 0.0;
  for (const int index : rim.corners)
    for (const auto& t : fans.at(index)) {
      if (std::find(t.begin(), t.end(), torn) != t.end()) continue;
      for (std::size_t k = 0; k < 3; ++k)
        longestEdge =
            std::max(longestEdge, (corner(surface, t[k]) - corner(surface, t[(k + 1) % 3])).norm());
    }
  return longestEdge;
}

/// A corner that was moved away from its neighbors, and how far.
std::optional<std::pair<int, double>> tornCorner(const Surface& surface, const SurfaceRim& rim,
                                                 const Fans& fans)
{
  for (const int index : rim.corners) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const int other : rim.corners)
      if (other != index)
        nearest = std::min(nearest, (corner(surface, other) - corner(surface, index)).norm());
    if (nearest > harmlessCrack &&
        nearest > tornEdges * longestEdgeBeside(surface, rim, fans, index))
      return std::pair(index, nearest);
  }
  return std::nullopt;
}

SurfaceRim rimOf(const Surface& surface, std::vector<int> corners)
{
  SurfaceRim rim{std::move(corners), 0.0};
  for (std::size_t k = 0; k < rim.corners.size(); ++k)
    rim.length += (corner(surface, rim.corners[(k + 1) % rim.corners.size()]) -
                   corner(surface, rim.corners[k]))
                      .norm();
  return rim;
}

/// Area vector of the rim's fan [m^2].
Eigen::Vector3d areaOf(const Surface& surface, const SurfaceRim& rim)
{
  const Eigen::Vector3d origin = corner(surface, rim.corners.front());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < rim.corners.size(); ++k)
    sum += 0.5 * (corner(surface, rim.corners[k]) - origin)
                     .cross(corner(surface, rim.corners[(k + 1) % rim.corners.size()]) - origin);
  return sum;
}

/// How far the wall at a rim lies in the rim's plane: mean cosine of both normals, 0 to 1.
double inPlane(const Surface& surface, const SurfaceRim& rim, const Fans& fans)
{
  const Eigen::Vector3d plane = areaOf(surface, rim).normalized();
  std::set<std::array<int, 3>> wall;
  for (const int index : rim.corners) wall.insert(fans.at(index).begin(), fans.at(index).end());
  double sum = 0.0, areas = 0.0;
  for (const auto& t : wall) {
    const Eigen::Vector3d area = (corner(surface, t[1]) - corner(surface, t[0]))
                                     .cross(corner(surface, t[2]) - corner(surface, t[0]));
    sum += std::abs(area.dot(plane));
    areas += area.norm();
  }
  return sum / std::max(areas, std::numeric_limits<double>::min());
}

}  // namespace

std::string placeOf(const Surface& surface, int index)
{
  const Eigen::Vector3d place = 1e3 * corner(surface, index);
  return "(" + inText(place.x(), "%.2f") + ", " + inText(place.y(), "%.2f") + ", " +
         inText(place.z(), "%.2f") + ") mm";
}

Error tornAt(const Surface& surface, int index, double gap)
{
  return Error{
      "The surface is torn at %1: a corner lies %2 mm from the others of its rim. Repair it there "
      "in the segmentation program, or export it again.",
      placeOf(surface, index), inText(1e3 * gap, "%.2f")};
}

std::vector<SurfaceRim> rimsOf(const Surface& surface)
{
  std::map<Edge, std::pair<int, Edge>> edges;  // how many triangles, and the way of the last one
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      auto& edge = edges[{std::min(a, b), std::max(a, b)}];
      ++edge.first;
      edge.second = {a, b};
    }
  std::multimap<int, int> next;
  for (const auto& [ends, edge] : edges)
    if (edge.first == 1) next.emplace(edge.second.second, edge.second.first);
  std::vector<SurfaceRim> rims;
  while (!next.empty()) {
    // where a line comes back to one of its corners, the loop between is a rim of its own
    std::vector<int> line;
    for (auto step = next.begin(); step != next.end();) {
      const int from = step->first;
      const auto loop = std::find(line.begin(), line.end(), from);
      if (loop != line.end()) {
        rims.push_back(rimOf(surface, {loop, line.end()}));
        line.erase(loop, line.end());
      }
      line.push_back(from);
      const int to = step->second;
      next.erase(step);
      step = next.find(to);
    }
    rims.push_back(rimOf(surface, std::move(line)));
  }
  std::sort(rims.begin(), rims.end(),
            [](const SurfaceRim& a, const SurfaceRim& b) { return a.length > b.length; });
  return rims;
}

Result<void> checkRims(const Surface& surface, const std::vector<SurfaceRim>& rims)
{
  const Fans fans = fansOf(surface, rims);
  for (const SurfaceRim& rim : rims)
    if (const auto torn = tornCorner(surface, rim, fans))
      return tornAt(surface, torn->first, torn->second);
  if (rims.size() > 1 && rims[1].length > openingRim)
    return Error{
        "The surface has more than one opening: rims of %1 mm at %2 and %3 mm at %4. Only the "
        "round window may be open; close the other.",
        inText(1e3 * rims[0].length, "%.2f"), placeOf(surface, rims[0].corners[0]),
        inText(1e3 * rims[1].length, "%.2f"), placeOf(surface, rims[1].corners[0])};
  if (rims.empty() || !(rims[0].length > openingRim)) return {};
  const double circularity =
      4.0 * pi * areaOf(surface, rims[0]).norm() / (rims[0].length * rims[0].length);
  const double flat = inPlane(surface, rims[0], fans);
  if (circularity < minCircularity)
    return Error{
        "The surface is torn at %1: its longest rim is a slit of %2 mm, not the opening of a scala "
        "tympani at the round window. Repair it there in the segmentation program, or export it "
        "again.",
        placeOf(surface, rims[0].corners[0]), inText(1e3 * rims[0].length, "%.2f")};
  if (flat > maxInPlane)
    return Error{
        "The surface has a hole at %1 with a rim of %2 mm in the side of its wall, not across the "
        "duct as the opening at the round window. Close it in the segmentation program.",
        placeOf(surface, rims[0].corners[0]), inText(1e3 * rims[0].length, "%.2f")};
  return {};
}

}  // namespace perilymph::anatomy
