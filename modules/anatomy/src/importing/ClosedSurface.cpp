// SPDX-License-Identifier: BSD-3-Clause
#include "importing/ClosedSurface.h"
#include "importing/NumberText.h"
#include "importing/SurfaceCracks.h"
#include "importing/SurfaceRims.h"
#include "mesh/Triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace perilymph::anatomy {
namespace {

constexpr int minTriangles = 200;
// A cochlea's A is 7.9 to 10.8 mm (numbers of three surveys); with its height and a lead-in, the
// longest side of its bounding box is within these limits.
constexpr double minSide = 5e-3, maxSide = 20e-3;
// 23 to 50 mm3 in 30 micro-CTs (Dhanasingh 2021), widened for differences in segmentation.
constexpr double minVolume = 12e-9, maxVolume = 90e-9;
constexpr double maxOddFraction = 0.01;  // maximum fraction of non-manifold edges

using Edge = std::pair<int, int>;

/// Merges equal corners and removes triangles without area.
Surface merged(const Surface& soup)
{
  Surface result;
  std::map<std::array<double, 3>, int> names;
  std::vector<int> nameOf;
  for (const auto& point : soup.points) {
    const auto [place, isNew] = names.try_emplace(point, static_cast<int>(result.points.size()));
    if (isNew) result.points.push_back(point);
    nameOf.push_back(place->second);
  }
  for (const auto& t : soup.triangles) {
    const std::array<int, 3> named = {nameOf[static_cast<std::size_t>(t[0])],
                                      nameOf[static_cast<std::size_t>(t[1])],
                                      nameOf[static_cast<std::size_t>(t[2])]};
    if (named[0] != named[1] && named[1] != named[2] && named[2] != named[0])
      result.triangles.push_back(named);
  }
  return result;
}

/// The triangles of each edge, by its corners in ascending order.
std::map<Edge, std::vector<int>> trianglesAtEdges(const Surface& surface)
{
  std::map<Edge, std::vector<int>> edges;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = surface.triangles[i][k], b = surface.triangles[i][(k + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}].push_back(static_cast<int>(i));
    }
  return edges;
}

bool runsAlong(const std::array<int, 3>& triangle, int from, int to)
{
  for (std::size_t k = 0; k < 3; ++k)
    if (triangle[k] == from && triangle[(k + 1) % 3] == to) return true;
  return false;
}

/// Orients neighboring triangles consistently, starting from the first one of each component;
/// counts the components.
int turnOneWay(Surface& surface, const std::map<Edge, std::vector<int>>& edges)
{
  std::vector<bool> isSeen(surface.triangles.size(), false);
  int pieces = 0;
  for (std::size_t first = 0; first < isSeen.size(); ++first) {
    if (isSeen[first]) continue;
    ++pieces;
    std::vector<int> waiting{static_cast<int>(first)};
    isSeen[first] = true;
    while (!waiting.empty()) {
      const auto here = surface.triangles[static_cast<std::size_t>(waiting.back())];
      waiting.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = here[k], b = here[(k + 1) % 3];
        for (const int next : edges.at({std::min(a, b), std::max(a, b)})) {
          if (isSeen[static_cast<std::size_t>(next)]) continue;
          isSeen[static_cast<std::size_t>(next)] = true;
          auto& other = surface.triangles[static_cast<std::size_t>(next)];
          if (runsAlong(other, a, b)) std::swap(other[1], other[2]);
          waiting.push_back(next);
        }
      }
    }
  }
  return pieces;
}

double volumeOf(const Surface& surface)
{
  const Eigen::Vector3d origin = corner(surface, 0);
  double sum = 0.0;
  for (const auto& t : surface.triangles)
    sum += (corner(surface, t[0]) - origin)
               .dot((corner(surface, t[1]) - origin).cross(corner(surface, t[2]) - origin)) /
           6.0;
  return sum;
}

Result<void> checkPoints(const Surface& soup)
{
  if (soup.triangles.size() < static_cast<std::size_t>(minTriangles))
    return Error{
        "The surface has %1 triangles; a scala tympani needs at least %2. Export the segmentation "
        "as triangles.",
        soup.triangles.size(), minTriangles};
  const auto count = static_cast<int>(soup.points.size());
  for (const auto& t : soup.triangles)
    for (const int index : t)
      if (index < 0 || index >= count)
        return Error{
            "A triangle of the surface names the corner %1, but there are %2. Export the surface "
            "again.",
            index, count};
  Eigen::Vector3d low = corner(soup, soup.triangles[0][0]), high = low;
  for (const auto& t : soup.triangles)
    for (const int index : t) {
      const Eigen::Vector3d p = corner(soup, index);
      if (!p.allFinite())
        return Error{"A corner of the surface is not a finite number. Export the surface again."};
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const double side = (high - low).maxCoeff();
  if (side < minSide || side > maxSide)
    return Error{
        "The surface is %1 mm long; a scala tympani is between %2 and %3 mm. Surfaces are read in "
        "millimeters; export it so.",
        inText(1e3 * side, "%.4g"), inText(1e3 * minSide, "%.0f"), inText(1e3 * maxSide, "%.0f")};
  return {};
}

}  // namespace

Result<ClosedSurface> closeSurface(const Surface& soup)
{
  if (const auto fine = checkPoints(soup); !fine) return fine.error();
  ClosedSurface result;
  result.surface = merged(soup);
  if (const auto fine = closeCracks(result.surface); !fine) return fine.error();
  auto edges = trianglesAtEdges(result.surface);
  std::size_t crowded = 0;
  for (const auto& [edge, triangles] : edges)
    if (triangles.size() > 2) ++crowded;
  if (static_cast<double>(crowded) > maxOddFraction * static_cast<double>(edges.size()))
    return Error{
        "At %1 of %2 edges of the surface more than two triangles meet; it must be the one wall of "
        "the scala. Repair it in the segmentation program.",
        crowded, edges.size()};
  if (const int pieces = turnOneWay(result.surface, edges); pieces != 1)
    return Error{
        "The surface has %1 separate pieces; it must be one. Keep the scala tympani alone.",
        pieces};

  // the longest rim is the opening, shorter ones are holes
  const std::vector<SurfaceRim> rims = rimsOf(result.surface);
  if (const auto fine = checkRims(result.surface, rims); !fine) return fine.error();
  result.spike = highestSpike(result.surface);
  if (!result.spike && !rims.empty() && rims[0].length > openingRim)
    result.spike = highestSpike(result.surface, rims[0]);
  result.isLid.assign(result.surface.triangles.size(), false);
  for (std::size_t i = 0; i < rims.size(); ++i) {
    const std::vector<int>& rim = rims[i].corners;
    const bool isOpening = i == 0 && rims[i].length > openingRim;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int index : rim) middle += corner(result.surface, index);
    middle /= static_cast<double>(rim.size());
    const int name = static_cast<int>(result.surface.points.size());
    result.surface.points.push_back({middle.x(), middle.y(), middle.z()});
    for (std::size_t k = 0; k < rim.size(); ++k) {
      result.surface.triangles.push_back({rim[k], rim[(k + 1) % rim.size()], name});
      result.isLid.push_back(isOpening);
      if (isOpening) result.rim.push_back(corner(result.surface, rim[k]));
    }
  }

  result.volume = volumeOf(result.surface);
  if (result.volume < 0.0) {
    for (auto& t : result.surface.triangles) std::swap(t[1], t[2]);
    result.volume = -result.volume;
  }
  if (result.volume < minVolume || result.volume > maxVolume)
    return Error{
        "The surface encloses %1 mm3; a scala tympani holds 23 to 50 mm3, and %2 to %3 are read. "
        "Keep the scala tympani alone, in millimeters.",
        inText(1e9 * result.volume, "%.3g"), inText(1e9 * minVolume, "%.0f"),
        inText(1e9 * maxVolume, "%.0f")};
  return result;
}

}  // namespace perilymph::anatomy
