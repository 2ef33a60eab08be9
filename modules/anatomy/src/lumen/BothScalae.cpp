// SPDX-License-Identifier: BSD-3-Clause

// The ducts of an array that went through the partition: the scala vestibuli, and both scalae as one.

#include <algorithm>
#include <cmath>

#include "lumen/Outline.h"
#include "lumen/ScalaeAbove.h"
#include "lumen/SectionWall.h"
#include "perilymph/anatomy/ScalaVestibuli.h"

namespace perilymph::anatomy {
namespace {

/// Corners of a section's outline for the walls between the scalae.
constexpr int corners = 360;

/// The tables of a duct whose sections are centered at these heights; walls are left out.
SectionTables centeredAt(const ScalaTympani& scala, const char* name,
                         const std::vector<double>& heights)
{
  SectionTables tables = scala.tables();
  tables.name = tables.name + ", " + name;
  // the partition keeps its place in space
  for (std::size_t i = 0; i < heights.size(); ++i)
    tables.membraneHeight[i] += tables.centerHeight[i] - heights[i];
  tables.centerHeight = heights;
  return tables;
}

/// A section of the scala tympani below its widest points, the same mirrored, and vertical walls
/// between the two.
Outline withoutPartition(const ScalaTympani& scala, double angle, double mirror)
{
  const SectionWall wall(scala, angle);
  Outline whole;
  for (const Direction& direction : directionsAround<corners>()) {
    const Eigen::Vector3d at = wall.at(direction);
    whole.push_back({std::sqrt(at.x() * at.x() + at.y() * at.y()), at.z()});
  }
  const auto isNearer = [](const HalfPlanePoint& a, const HalfPlanePoint& b) { return a.r < b.r; };
  const auto [inner, outer] = std::minmax_element(whole.begin(), whole.end(), isNearer);
  // counter-clockwise along the floor, from the inner wall to the outer one
  Outline both;
  const auto count = static_cast<std::size_t>(corners);
  const auto last = static_cast<std::size_t>(outer - whole.begin());
  for (auto k = static_cast<std::size_t>(inner - whole.begin()); k != last; k = (k + 1) % count)
    both.push_back(whole[k]);
  both.push_back(whole[last]);
  for (std::size_t k = both.size(); k-- > 0;) both.push_back({both[k].r, 2.0 * mirror - both[k].z});
  return both;
}

/// Section::roofHeight: of the same directions those upward, since the others lie below the center.
double roofHeight(const ScalaTympani& scala, double angle)
{
  constexpr std::size_t steps = 720;
  const SectionWall outline(scala, angle);
  const auto& rays = directionsAround<steps>();
  double roof = -1e9;
  for (std::size_t k = 0; k <= steps / 2; ++k) roof = std::max(roof, outline.at(rays[k]).z());
  return roof;
}

}  // namespace

std::vector<double> partitionHeights(const ScalaTympani& scala)
{
  std::vector<double> heights;
  for (std::size_t i = 0; i < scala.tables().centerHeight.size(); ++i) {
    const double angle = scala.tables().step * static_cast<double>(i);
    heights.push_back(std::max(roofHeight(scala, angle), scala.membrane_W(angle, 0.5).z()));
  }
  return heights;
}

std::shared_ptr<const ScalaTympani> ScalaeAbove::buildVestibuli(
    const ScalaTympani& scala, const std::vector<double>& partition)
{
  const SectionTables& below = scala.tables();
  std::vector<double> heights = partition;
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = 2.0 * heights[i] - below.centerHeight[i];
  SectionTables tables = centeredAt(scala, "scala vestibuli", heights);
  const auto directions = static_cast<std::size_t>(below.directions);
  for (std::size_t i = 0; i < heights.size(); ++i)
    for (std::size_t k = 0; k < directions; ++k)
      tables.wallRadius[i * directions + k] =
          below.wallRadius[i * directions + (directions - k) % directions];
  return std::make_shared<const ScalaTympani>(std::move(tables));
}

std::shared_ptr<const ScalaTympani> ScalaeAbove::buildBoth(const ScalaTympani& scala,
                                                           const std::vector<double>& heights)
{
  SectionTables tables = centeredAt(scala, "both scalae", heights);
  const auto directions = static_cast<std::size_t>(tables.directions);
  std::vector<SineCosine> rays;
  for (std::size_t k = 0; k < directions; ++k)
    rays.push_back(sineCosine(2.0 * pi * static_cast<double>(k) / static_cast<double>(directions)));
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double angle = tables.step * static_cast<double>(i);
    const Outline both = withoutPartition(scala, angle, heights[i]);
    std::size_t near = 0;
    for (std::size_t k = 0; k < directions; ++k) {
      const SineCosine& ray = rays[k];
      tables.wallRadius[i * directions + k] =
          radiusIn(both, {tables.centerRadius[i], heights[i]}, ray, near);
    }
  }
  return std::make_shared<const ScalaTympani>(std::move(tables));
}

std::shared_ptr<const ScalaTympani> vestibuliOf(const ScalaTympani& scala)
{
  return ScalaeAbove::of(scala).vestibuli(scala);
}

std::shared_ptr<const ScalaTympani> bothScalaeOf(const ScalaTympani& scala)
{
  return ScalaeAbove::of(scala).both(scala);
}

}  // namespace perilymph::anatomy
