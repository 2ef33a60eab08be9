// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Clinical measures of a cochlea, computed from the lumen used by the mechanics.

#include <string>
#include <utility>
#include <vector>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// One measure and how it was obtained.
struct Measure {
  std::string key;  ///< With its unit: "A_mm".
  double value;     ///< In that unit.
  std::string formula;
  std::string source;  ///< Source of the definition or the formula.
  /// Standard deviation that stands for the choice of the formula, in the value's unit.
  double formulaError = 0.0;
};

/// Measures a scala tympani without its lead-in: A, B, H, turns, lengths, volume, heights, the
/// section at the round window, and for comparison the clinical estimates from A and B.
///
/// The outer wall's length is measured through the outermost points of sections 22.5 degrees apart,
/// radius and height linear in the angle between them. It and the volume end at the last measured
/// section; if a model extrapolates, those to the apex are listed separately.
///
/// @param cochlea  What it was built from. The lengths that formulas give from A and B are those of the patient's
///                 A and B, as on all pages, if the model is scaled to them; else of those measured on the model,
///                 whose splines make them some ten-thousandths of a millimeter smaller than the patient's.
std::vector<Measure> measure(const anatomy::ScalaTympani& scala,
                             const anatomy::Cochlea& cochlea = {});

/// A and B of a lumen as built: diameters of the basal turn through the modiolar axis, to the outer
/// wall at 0 and 180 degrees, and at 90 and 270.
struct BasalDiameters {
  Length a, b;
};
BasalDiameters basalDiameters(const anatomy::ScalaTympani& scala);
/// Those of the patient that it is scaled to, if it is; else those of the lumen.
BasalDiameters basalDiameters(const anatomy::ScalaTympani& scala, const anatomy::Cochlea& cochlea);

/// Length of the organ of Corti in the plan view, from the round window to the apex: `st_length_mm`.
Length organOfCortiLength(const anatomy::ScalaTympani& scala);

/// Its part from the round window to an angle, 0 to 1; for places in one cochlea.
class OrganOfCorti {
public:
  explicit OrganOfCorti(const anatomy::ScalaTympani& scala);
  double fractionAt(Angle angle) const noexcept;

private:
  double step_;                 // between the entries [rad]
  std::vector<double> length_;  // from the round window [m]
};

/// One section in a half-plane through the modiolar axis, for a table.
struct SectionRow {
  double angle;  ///< From the round window [rad].
  anatomy::Section section;
  double outerWallLength;     ///< Along the outer wall from the round window [m].
  double centerLength;        ///< Along the sections' centers [m].
  double innerWallLength;     ///< Along the inner wall [m].
  double organOfCortiLength;  ///< Along the organ of Corti, in the plan view [m].
};

/// Sections at equal angles from the round window to the apex.
///
/// @param maxStep  Maximum angle between two sections; reduced so that the last one is at the apex.
std::vector<SectionRow> sectionRows(const anatomy::ScalaTympani& scala, Angle maxStep);

/// The sections as columns by name with unit, in the order of a table, with the characteristic
/// frequency by Greenwood (from the fraction of the path's length to the last row) and by the spiral
/// ganglion (from the angle).
std::vector<std::pair<const char*, std::vector<double>>> sectionColumns(
    const std::vector<SectionRow>& rows);

/// "angle_deg,center_r_mm,...\n" and a row per section: sectionColumns() as text.
std::string sectionsCsv(const std::vector<SectionRow>& rows);

}  // namespace perilymph::analysis
