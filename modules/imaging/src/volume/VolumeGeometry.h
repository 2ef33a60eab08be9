// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the geometry of every volume file must be.

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Axis of voxels behind a quantity: " along i".
Sentence alongAxis(Eigen::Index axis);

/// Refuses a matrix that is not finite, voxels below 0.01 or above 10 mm, and axes that do not meet at
/// right angles within a thousandth of a radian: a sheared volume would be measured wrong.
///
/// @param unit  The file's unit of length and where it is stated, for the sentence.
Result<void> checkVoxels(const std::filesystem::path& file, const Eigen::Matrix4d& lps_PI,
                         const Sentence& unit);

/// Refuses sizes that are no volume or beyond maxCtVoxels.
Result<void> checkVolumeSize(const std::filesystem::path& file, const std::array<double, 3>& size);

}  // namespace perilymph::imaging
