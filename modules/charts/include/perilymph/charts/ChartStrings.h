#pragma once

// What charts and flat views say, in the language of whoever shows them.

#include <string>
#include <vector>

namespace perilymph::charts {

/// Words on charts and flat views; English until others are set. %1 and %2 stand for numbers.
struct ChartStrings {
  std::string travel = "travel, mm";
  std::string axialForce = "axial force, N";
  std::string force = "force, mN";
  std::string now = "now";
  std::string thisInsertion = "this insertion";
  std::string feltBySurgeons = "felt by surgeons 20 mN";
  std::string axial = "axial", lateral = "lateral", vertical = "vertical";
  std::string outerWall = "outer wall", modiolus = "modiolus";
  std::string basilarMembrane = "basilar membrane";
  std::string wallForceScale = "wall force, 50 mN per mm";
  std::string wallForce = "wall force %1 mN";
  std::string unrolledAxes = "angle from round window, °; width, mm";
  std::string tipIsOutside = "the tip is outside";
  std::string noContactInside = "no contact is inside yet";
  std::string meanAndInside = "mean %1 mm, %2 inside";
  char decimalSign = '.';
};

/// Sets the strings of all charts and views made from then on.
void setChartStrings(ChartStrings strings);
const ChartStrings& chartStrings();

/// Words with numbers in place of %1, %2.
std::string filled(std::string text, const std::vector<std::string>& numbers);
/// A number as printf writes it, with the sign that people read.
std::string withDecimalSign(std::string number);

}  // namespace perilymph::charts
