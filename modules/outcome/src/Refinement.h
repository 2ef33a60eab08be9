// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A model of the image of the array, fitted to the voxels around it.
//
//     I(x) = min(c, f + (b - f) bone(x) + sum over contacts a_i G(x - p_i; S_i) + integral n(s) w G(x - p(s); S) ds)
//
// with the scanner's limit c, levels b and f of bone and of the lumen's content, amplitudes a_i, positions p_i,
// the density w of each of n(s) wires, one for each contact nearer to the tip, along a smooth curve in the carrier's center, and G the normal density of the scanner's blur S,
// for S_i widened by the contact's plates: a single one, a pair beside the center line or a band, as the array's file
// says. Consecutive contacts keep the array's spacing.

#include <Eigen/Core>
#include <vector>

#include "MetalGrid.h"
#include "perilymph/ct/CtVolume.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::outcome {

/// Distance of the contacts from the array's center line, toward the inner side of its bend, as a part of its half
/// thickness: they lie on the surface, bands reach around it (choice, low confidence).
inline constexpr double contactOffset = 0.7;

/// Distance of neighboring points of the lead.
inline constexpr double leadStep_mm = 1.5;

/// The chain before or after the fit.
struct FittedChain {
  std::vector<Eigen::Vector3d> position_P;    ///< Contacts from the tip, then points of the lead.
  std::vector<Eigen::Matrix3d> covariance_P;  ///< Statistical covariance of each contact [mm^2].
  std::vector<double> amplitude;              ///< Each contact's [intensity mm^3].
  double blurInPlane_mm = 0.2, blurAxial_mm = 0.2;  ///< Standard deviations.
  double residual = 0.0;      ///< Robust standard deviation of what is left [intensity].
  double lengthMisfit = 0.0;  ///< Root mean square of spacing errors, in their standard deviations.
  std::vector<double> excess_mm;  ///< Distance of contacts i and i + 1 less what it should be.
  double cost =
      0.0;  ///< Minus twice the logarithm of the likelihood, with the priors, but for a constant of the voxels.
};

/// What the fit may change.
struct RefinementSettings {
  bool isSeenSingly =
      true;  ///< Else all contacts share an amplitude but for a tenth of its square.
  std::vector<bool> isFixed;  ///< Contacts that a person placed.
  int rounds = 50;
};

/// A voxel of a fit.
struct FitVoxel {
  Eigen::Vector3d point_P;
  double intensity, bone;  ///< `bone`: its part of bone, see EarFrame::bonePart().
};

/// The voxels near points, for all fits that are to be compared by their costs.
///
/// @param blur_mm  Standard deviation of the blur in plane.
std::vector<FitVoxel> voxelsNear(const ct::CtVolume& volume, const EarFrame& frame,
                                 const std::vector<Eigen::Vector3d>& points_P, double blur_mm);

/// Fits the model to voxels. `start` gives the positions of all contacts, in P, and points of the lead,
/// leadStep_mm apart.
FittedChain refined(const EarFrame& frame, const ct::CtVolume& volume, const MetalGrid& grid,
                    const Ear& ear, const std::vector<FitVoxel>& voxels,
                    const electrode::ArrayDesign& array, const FittedChain& start,
                    const RefinementSettings& settings);

}  // namespace perilymph::outcome
