// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The CT of an implanted phantom, from projections: parallel beams, slice by slice.
//
// The head is an ellipse of soft tissue with a skull and both temporal bones as homogeneous ellipses, whose line
// integrals are known. Around the ear they are replaced by the anatomy on a grid of the size of a voxel, and the
// metal by its pieces at 0.05 mm. Each detector element sums intensities over its aperture, the focal spot, the
// slice and the energies of the beam:
//
//     I = sum_E S(E) exp(-mu_water L_water - mu_bone L_bone) < exp(-mu_metal L_metal) >
//
// to which scatter, Poisson and electronic noise are added. What is logged is corrected for water. The projections
// of the homogeneous head are subtracted before the filtered back projection, so that nothing is truncated.

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "ImplantGeometry.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::test {

/// What is scanned.
struct ImplantScene {
  std::function<double(const Eigen::Vector3d& point_P, double cell)>
      intensity;                  ///< Without metal [HU].
  std::vector<MetalPiece> metal;  ///< All in view, in P.
  Eigen::Vector3d center_P;       ///< The middle of the volume.
  bool isRight = true;
};

ct::CtVolume scanned(const ImplantScene& scene, const ImplantScan& scan, std::uint64_t seed);

}  // namespace perilymph::test
