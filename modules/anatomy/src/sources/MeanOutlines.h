// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The mean scala tympani, interpolated between and extrapolated beyond its measured sections.

#include <vector>

#include "lumen/Outline.h"
#include "numerics/KnotSpline.h"
#include "perilymph/anatomy/MeanScala.h"

namespace perilymph::anatomy {

/// Outlines of the mean scala tympani at any angle, before scaling to a patient.
class MeanOutlines {
public:
  explicit MeanOutlines(const std::vector<MeasuredSection>& sections);

  /// Angle of the end of the lumen [rad].
  static double lastAngle();

  /// Angle of the last measured section [rad].
  double measuredAngle() const { return measured_; }

  /// The outline at an angle from the round window, counter-clockwise.
  Outline outline(double angle) const;
  /// Scale of the section within the rounded cap at the apex; 1 before it.
  static double capFraction(double angle);
  /// Distance of the organ-of-Corti path from the axis [m].
  double organOfCorti(double angle) const;

private:
  Outline outline(double angle, double fraction) const;

  double measured_;
  std::vector<KnotSpline> real_, imaginary_;  ///< Coefficients over the angle.
};

/// Width of the basilar membrane [m]: linear from 0.15 mm at the round window to 0.52 mm at the
/// apex (Todd and Naghdy, section II.B).
double membraneWidth(double angle, double lastAngle);

}  // namespace perilymph::anatomy
