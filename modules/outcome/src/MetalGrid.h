// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The metal around an ear: the volume on an isotropic grid, above the level of bone.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "EarFrame.h"
#include "perilymph/ct/CtVolume.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::outcome {

/// Values on an isotropic grid along the axes of P.
struct MetalGrid {
  std::array<int, 3> size{};
  double step_mm = 0.2;
  Eigen::Vector3d first_P = Eigen::Vector3d::Zero();  ///< Center of the first cell.
  std::vector<float> value;  ///< Intensity above what bone and lumen can have there, at least 0.
  double bone = 0.0;         ///< Median intensity of the bone around the cochlea.
  double boneSpread = 0.0;   ///< Its standard deviation, by quartiles.
  double floor = 0.0;        ///< Above this a voxel is not bone; in the lumen less counts as metal.
  double aboveBone_mm3 = 0.0;  ///< Volume near the duct that is brighter than any bone.
  double ceiling = 1e9;        ///< Intensity at which the scanner clips; 1e9: it does not.

  std::size_t index(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
  Eigen::Vector3d at_P(int i, int j, int k) const
  {
    return first_P + step_mm * Eigen::Vector3d(i, j, k);
  }
  /// Trilinear; 0 outside.
  double sample(const std::vector<float>& values, const Eigen::Vector3d& point_P) const;
};

/// What is subtracted in the lumen above its content [intensity].
inline constexpr double aboveContent = 350.0;

/// The metal within `reach_mm` of the cochlea along every axis.
MetalGrid metalAround(const ct::CtVolume& volume, const Ear& ear, const EarFrame& frame,
                      double reach_mm, double blur_mm);

/// Separable Gaussian of a standard deviation in mm.
std::vector<float> blurred(const MetalGrid& grid, const std::vector<float>& values,
                           double sigma_mm);

/// Difference of two Gaussians of the metal, of `sigma_mm` and 1.6 times it: large at spots of that size.
std::vector<float> contrastOf(const MetalGrid& grid, double sigma_mm);

/// A bright place: the center of a blob.
struct Blob {
  Eigen::Vector3d position_P = Eigen::Vector3d::Zero();
  /// Least curvature of the blurred metal there, along whatever direction: of a contact much, along a wire none.
  double strength = 0.0;
};

/// Local maxima of contrastOf(), to a fraction of a cell, the strongest first.
std::vector<Blob> blobsOf(const MetalGrid& grid, double sigma_mm);

}  // namespace perilymph::outcome
