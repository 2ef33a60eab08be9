// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Colors and texts of charts and flat views, given to each when it is made.

#include <string>

#include "perilymph/figures/Palette.h"

namespace perilymph::charts {

/// Texts of charts and flat views, English by default. %1 and %2 are placeholders of numbers.
struct ChartStrings {
  std::string travel = "travel, mm";
  std::string axialForce = "insertion force, mN";
  std::string force = "force, mN";
  std::string now = "now";
  std::string thisInsertion = "this insertion";
  std::string feltBySurgeons = "perception threshold %1 mN";
  std::string axial = "axial", lateral = "lateral", vertical = "vertical";
  std::string outerWall = "outer wall", modiolus = "modiolus";
  std::string basilarMembrane = "basilar membrane";
  std::string wallForceScale = "wall force, 50 mN per mm";
  std::string wallForce = "wall force %1 mN";
  std::string unrolledAxes = "angle from round window, °; width, mm";
  std::string tipIsOutside = "tip is outside the cochlea";
  std::string noContactInside = "no contact inserted yet";
  std::string meanAndInside = "mean %1 mm, %2 inserted";
  std::string meanAndAbove = "mean %1 mm, %2 below the partition, %3 above";
  std::string onlyAbove = "%1 above the partition";
  std::string rupture = "rupture";
  std::string rib = "rib %1";
  char decimalSign = '.';
};

struct ChartStyle {
  figures::ColorScheme scheme = figures::ColorScheme::dark;
  ChartStrings strings;
};

}  // namespace perilymph::charts
