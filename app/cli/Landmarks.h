// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Points that people marked in 3D Slicer.

#include <Eigen/Core>
#include <filesystem>
#include <optional>

#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Landmarks of a cochlea, LPS [mm]; at least one is there.
struct Landmarks {
  std::optional<Eigen::Vector3d> roundWindow_P;  ///< "RW": center of the round window.
  std::optional<Eigen::Vector3d> center_P;       ///< "C": modiolus in the basal turn.
  std::optional<Eigen::Vector3d> apex_P;         ///< "A".

  /// A point in the cochlea.
  Eigen::Vector3d inside_P() const;
};

/// Reads a markups file (.mrk.json) with points named RW, C or A, in LPS or RAS.
Result<Landmarks> readLandmarks(const std::filesystem::path& file);

}  // namespace perilymph::cli
