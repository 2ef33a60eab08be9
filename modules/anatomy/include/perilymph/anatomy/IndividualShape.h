// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The shape of one cochlea beyond its A, B and H: how it differs along the scala from the mean one.

#include <array>

#include "perilymph/anatomy/Population.h"

namespace perilymph::anatomy {

/// A function of the angle, a sum of cosines:
///
///     f(theta) = amplitude sum over i of cos(frequency_i theta + phase_i)
///
/// With phases uniform over a turn and frequencies normal with standard deviation 1/l, n of them and
/// the amplitude s sqrt(2/n), f has mean 0, standard deviation s and the covariance
/// s^2 exp(-d^2 / 2 l^2) between angles d apart (Rahimi and Recht 2007). Zero everywhere by default.
struct AngularVariation {
  struct Wave {
    double frequency = 0.0;  ///< Per radian of the angle.
    double phase = 0.0;      ///< [rad]
  };
  double amplitude = 0.0;  ///< In the unit of f.
  std::array<Wave, 16> waves{};

  /// f at an angle from the round window [rad].
  double at(double angle) const;
};

/// The shape of a cochlea beyond its A, B and H.
struct IndividualShape {
  HalfDiameters half;    ///< Only the course of the spiral between A and B counts.
  double section = 1.0;  ///< Factor of the sections' width and height, with the outer wall kept.
  AngularVariation sections = {};  ///< Natural logarithm of a further factor, along the scala.
  AngularVariation course = {};    ///< Height of the center line above the mean's course [m].
  AngularVariation radius = {};    ///< Relative change of the outer wall's distance from the axis.
  double height = 1.0;             ///< Factor of the mean shape's H; only if no H was measured.

  /// Factor of the sections' width and height at an angle from the round window [rad].
  double sectionAt(double angle) const;
};

}  // namespace perilymph::anatomy
