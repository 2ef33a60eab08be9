#pragma once

// Real ears with labels and landmarks, from a folder that the environment names. The project ships
// none.

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::test {

/// One ear: a CT crop, the hand-drawn labyrinth, landmarks. LPS mm.
struct RealEar {
  std::string name;
  bool isRight = true;
  ct::CtVolume ct, label;  ///< Label: 100 inside the labyrinth, 0 outside.
  Eigen::Vector3d roundWindow_P, center_P, apex_P;
  Eigen::Matrix3d axes_PW;  ///< Published frame: x to the round window, z along the axis.
};

/// The folder that PERILYMPH_EARS names; none if it names none.
std::optional<std::filesystem::path> realEarFolder();

/// Names of the ears in a folder: `<name>_CT_RAW.nii.gz`, sorted.
std::vector<std::string> realEarNames(const std::filesystem::path& folder);

/// Reads one ear. @throws std::runtime_error with a sentence.
RealEar loadRealEar(const std::filesystem::path& folder, const std::string& name);

}  // namespace perilymph::test
