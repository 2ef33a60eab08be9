// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Constant data of a point set: the carrier's parameters and the surface that it touches.

#include <Eigen/Core>
#include <cstdint>

#include "PublishedCarrier.h"
#include "perilymph/mechanics/PointSet.h"
#include "points/ProxySurface.h"

namespace perilymph::mechanics {

/// Parameters of the published carrier (Todd and Naghdy, section II.D; confidence high).
struct PointSetLaw {
  double radius = 0.25e-3;   ///< Radius of a point: the measured tip of a Contour [m].
  double stiffness = 350.0;  ///< Stiffness between a point and its anchor [N/m].
  double damping = 1.0;      ///< The same [N.s/m].
  double turningStiffness =
      0.2;                       ///< Rotational stiffness of the carrier in the tweezers [N.m/rad].
  double turningDamping = 3e-5;  ///< The same [N.m.s/rad].
  double mass = publishedMass;   ///< Mass of array and tweezers, weighed [kg].
  Eigen::Vector3d box{30e-3, 20e-3, 20e-3};  ///< Along E's axes [m].
  double surfaceDamping = 0.01;              ///< [N.s/m]
};

/// Constant data of a point set, in addition to the common parts of InsertionModel.
struct PointSetModel {
  /// @throws std::invalid_argument with a message for an invalid surface.
  PointSetModel(const anatomy::Surface& hapticSurface, int points, double timeStep,
                const PointSetLaw& law = {});

  PointSetLaw law;
  ProxySurface surface;
  double pointMass = 0.0;                             ///< [kg]
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();  ///< About E's axes [kg.m^2].
  int substeps = 1;                                   ///< Substeps of one time step.
  double substep = 0.0;                               ///< [s]
  std::uint64_t fingerprint = 0;
};

}  // namespace perilymph::mechanics
