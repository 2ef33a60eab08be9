// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Real ears with labels and landmarks, from a folder named by an environment variable. The project
// includes none.

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::test {

/// One ear: a CT crop, the manually segmented labyrinth, landmarks. LPS mm.
struct RealEar {
  std::string name;
  bool isRight = true;
  ct::CtVolume ct, label;  ///< Label: 100 inside the labyrinth, 0 outside.
  Eigen::Vector3d roundWindow_P, center_P, apex_P;
  Eigen::Matrix3d axes_PW;  ///< Published frame: x toward the round window, z along the axis.
};

/// The folder named by PERILYMPH_EARS; empty if it is not set.
std::optional<std::filesystem::path> realEarFolder();

/// Names of the ears in a folder: `<name>_CT_RAW.nii.gz`, sorted.
std::vector<std::string> realEarNames(const std::filesystem::path& folder);

/// Reads one ear. @throws std::runtime_error with a message.
RealEar loadRealEar(const std::filesystem::path& folder, const std::string& name);

}  // namespace perilymph::test
