// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A scala in closed form: round sections along a known curve, with an array in it.

#include <cmath>
#include <memory>

#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::test {

inline constexpr double lumen_mm = 1.0;     ///< Radius of every section.
inline constexpr double diameter_mm = 0.6;  ///< Diameter of the array.
inline constexpr double turns_deg = 900.0;

/// From the axis to the centers of the sections: a ring of 3 mm that begins with a hook like a
/// cochlea; without the hook half of the first turn would lie in front of the opening's plane.
inline double ring_mm(double angle_deg)
{
  return 3.0 + 2.5 * std::exp(-degrees(angle_deg).si() / 0.6);
}

/// Sections of radius lumen_mm, every 10 degrees. They rise, so that turns do not overlap.
inline std::shared_ptr<const anatomy::ScalaTympani> ringScala()
{
  anatomy::SectionTables tables;
  tables.name = "ring";
  tables.step = degrees(10).si();
  tables.directions = 36;
  const int sections = int(turns_deg / 10.0) + 1;
  for (int i = 0; i < sections; ++i) {
    tables.centerRadius.push_back(1e-3 * ring_mm(10.0 * i));
    tables.centerHeight.push_back(1e-3 * 3.0 * i * 10.0 / 360.0);
    tables.membraneInner.push_back(-0.3e-3);
    tables.membraneOuter.push_back(0.3e-3);
    tables.membraneHeight.push_back(0.95e-3);
    tables.planRadius.push_back(1e-3 * ring_mm(10.0 * i));
    for (int k = 0; k < tables.directions; ++k) tables.wallRadius.push_back(1e-3 * lumen_mm);
  }
  tables.leadIn = 1e-3;
  static const auto scala = std::make_shared<const anatomy::ScalaTympani>(tables);
  return scala;
}

inline electrode::ArrayDesign plainArray()
{
  electrode::ArrayDesign array;
  array.length = millimeters(20);
  array.diameter = {{millimeters(0)}, {millimeters(diameter_mm)}};
  array.contactsFromTip = {millimeters(2), millimeters(5)};
  array.contactLength = millimeters(0.4);
  return array;
}

/// A point of the ring's section at an angle, relative to its center: outward and up [mm].
inline Eigen::Vector3d ringPlace_mm(double angle_deg, double across_mm, double up_mm)
{
  const double angle = degrees(angle_deg).si();
  const double r = ring_mm(angle_deg) + across_mm;
  return {r * std::cos(angle), r * std::sin(angle), 3.0 * angle_deg / 360.0 + up_mm};
}

inline constexpr int ringNodes = 101;

/// An array with nodes at equal angles up to the tip, all at the same position in their sections.
inline haptics::Snapshot laidTo(double tip_deg, double across_mm, double up_mm = 0.0)
{
  haptics::Snapshot now{};
  now.nodes = ringNodes;
  for (std::size_t i = 0; i < ringNodes; ++i) {
    const double angle_deg = tip_deg * double(i) / (ringNodes - 1);
    const Eigen::Vector3d place = 1e-3 * ringPlace_mm(angle_deg, across_mm, up_mm);
    for (int k = 0; k < 3; ++k) now.node_W[i][std::size_t(k)] = static_cast<float>(place[k]);
  }
  return now;
}

/// Sets the wall's force on a node: its components toward the outer wall and toward the apex.
inline void push(haptics::Snapshot& now, std::size_t node, double across_mN, double up_mN = 0.0)
{
  const Eigen::Vector2d outward =
      Eigen::Vector2d(now.node_W[node][0], now.node_W[node][1]).normalized();
  now.wallForce_W[node] = {static_cast<float>(1e-3 * across_mN * outward.x()),
                           static_cast<float>(1e-3 * across_mN * outward.y()),
                           static_cast<float>(1e-3 * up_mN)};
  now.normalForce[node] = static_cast<float>(1e-3 * std::hypot(across_mN, up_mN));
}

}  // namespace perilymph::test
