// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The neighborhood of a point, resampled on an isotropic grid aligned with the patient, and its
// intensity levels.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// Smoothed intensities on a cubic grid in P.
class Region {
public:
  static constexpr double step = 0.3;  ///< Between grid points [mm].

  /// Samples a cube of half width `radius_mm` aligned with P. Outside the volume the grid has no
  /// values.
  Region(const CtVolume& volume, const Eigen::Vector3d& center_P, double radius_mm);

  int count() const { return count_; }
  const Eigen::Vector3d& corner_P() const { return corner_P_; }
  Eigen::Vector3d point_P(int i, int j, int k) const
  {
    return corner_P_ + step * Eigen::Vector3d(i, j, k);
  }
  std::size_t index(int i, int j, int k) const
  {
    const auto n = static_cast<std::size_t>(count_);
    return (static_cast<std::size_t>(k) * n + static_cast<std::size_t>(j)) * n +
           static_cast<std::size_t>(i);
  }
  bool isKnown(std::size_t at) const { return known_[at] != 0; }
  float value(std::size_t at) const { return values_[at]; }

private:
  int count_ = 0;
  Eigen::Vector3d corner_P_;
  std::vector<float> values_;
  std::vector<unsigned char> known_;
};

/// Intensity levels in a temporal bone; not HU in a cone-beam scan.
struct Levels {
  double bone = 0.0;               ///< Otic capsule.
  std::vector<double> candidates;  ///< Possible contents of the lumen: fluid, air.
};

/// Finds the levels within `radius_mm` of a point: bone above Otsu's threshold (1979), the others
/// as peaks of the histogram of homogeneous points.
Levels findLevels(const Region& region, const Eigen::Vector3d& center_P, double radius_mm);

}  // namespace perilymph::ct
