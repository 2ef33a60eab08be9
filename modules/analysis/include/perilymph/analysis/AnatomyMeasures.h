#pragma once

// What a surgeon reads off a cochlea, measured from the lumen the mechanics uses.

#include <string>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// One measure with the way it was found.
struct Measure {
  std::string key;  ///< With its unit: "A_mm".
  double value;     ///< In that unit.
  std::string formula;
  std::string source;  ///< Source of the definition or the formula.
};

/// Measures a scala tympani without its lead-in: A, B, H, turns, lengths, volume, heights, the
/// section at the round window, and beside them what the clinic's formulas make of A and B.
///
/// The outer wall's length goes through the outermost points of sections 22.5 degrees apart, radius
/// and height linear in the angle between them. It and the volume end with the last measured
/// section; where a model goes on by a trend, those to the apex are told apart.
std::vector<Measure> measure(const anatomy::ScalaTympani& scala);

/// One section in a half-plane through the modiolar axis, as numbers for a table.
struct SectionRow {
  double angle;  ///< From the round window [rad].
  anatomy::Section section;
  double outerWallLength;     ///< Along the outer wall from the round window [m].
  double centerLength;        ///< Along the sections' centers [m].
  double innerWallLength;     ///< Along the inner wall [m].
  double organOfCortiLength;  ///< Along the organ of Corti's path in the plan [m].
};

/// Sections at equal angles from the round window to the apex.
///
/// @param most  The greatest angle between two sections; made smaller to end at the apex.
std::vector<SectionRow> sectionRows(const anatomy::ScalaTympani& scala, Angle maxStep);

/// "angle_deg,center_r_mm,...\n" and a row per section, with the tone of its place by Greenwood
/// (the path's share of its length to the last row) and by the spiral ganglion (the angle).
std::string sectionsCsv(const std::vector<SectionRow>& rows);

}  // namespace perilymph::analysis
