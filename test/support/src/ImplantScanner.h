// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A CT of an implanted phantom.

#include <Eigen/Core>
#include <cstdint>

#include "CtPhantomAnatomy.h"
#include "ImplantGeometry.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::test {

/// What is scanned.
struct ImplantScene {
  const PhantomAnatomy* anatomy;
  const electrode::ArrayDesign* array;
  const Course* course;
  std::vector<MetalPiece> metal;  ///< All in view: the array, and an old lead.
  Eigen::Matrix4d pose_PW;
  Eigen::Vector3d center_P;  ///< The middle of the volume.
};

ct::CtVolume scanned(const ImplantScene& scene, const ImplantScan& scan, std::uint64_t seed);

}  // namespace perilymph::test
