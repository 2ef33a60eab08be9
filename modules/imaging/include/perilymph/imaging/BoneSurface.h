// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The bone of a CT as a surface.

#include <Eigen/Core>
#include <stop_token>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::imaging {

/// Which part of a CT's bone becomes a surface.
struct BoneRequest {
  Eigen::Vector3d center_P = Eigen::Vector3d::Zero();  ///< [mm]
  double radius_mm = 0.0;                              ///< Bone outside of this ball is cut off.
  double level = 0.0;                                  ///< Bone has this intensity or more.
  double contrast = 1.0;  ///< Intensity of bone minus that beside it; positive.
  double step_mm = 0.3;   ///< Distance of the samples: the edge of a triangle.
  std::stop_token stop;
};

/// The intensity from which on a voxel is bone: the highest threshold of those that split the voxels
/// into classes with the least variance in each (Otsu 1979). A volume of a temporal bone has two
/// classes, bone and what is in it; one of more than 60 mm has soft tissue and air beside bone.
double boneLevelOf(const ct::CtVolume& volume);

/// A request for all bone of a volume, with samples so far apart that a picture of it turns
/// smoothly, and not closer than the voxels.
BoneRequest wholeBone(const ct::CtVolume& volume);

/// The isosurface of bone in P [m], closed where the ball or the volume ends; normals point out of
/// the bone. A sample is the mean of eight interpolated values around it, which removes noise, and
/// pieces of few triangles are omitted. Empty without bone, and if it was stopped. Takes tenths of
/// a second.
anatomy::Surface boneSurface(const ct::CtVolume& volume, const BoneRequest& request);

}  // namespace perilymph::imaging
