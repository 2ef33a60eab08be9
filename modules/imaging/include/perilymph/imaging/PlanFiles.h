// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What an insertion leaves for other programs, in the frame of the CT: markups and glTF.

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/ct/Marks.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Positions in P, LPS [mm].
struct PlanMarkups {
  std::string seriesKey = {};  ///< SHA-256 of the CT series that the positions are of.
  ct::Marks marks = {};
  std::optional<std::array<Eigen::Vector3d, 2>> axis = {};  ///< Modiolar axis, base to apex.
  std::optional<std::array<Eigen::Vector3d, 2>> insertionLine =
      {};                                      ///< From outside into the opening.
  std::vector<Eigen::Vector3d> array = {};     ///< Center line, base to tip.
  std::vector<Eigen::Vector3d> contacts = {};  ///< Number 1 at the tip.
};

/// The text of a markups file of 3D Slicer (.mrk.json): landmarks, lines "axis" and "insertion",
/// curve "array", points "E1", "E2", ... for the contacts. Parts that are missing are left out. The
/// description of each point names the series, so that readLandmarks() takes it for no other one.
std::string planText(const PlanMarkups& plan);

/// Writes a surface as glTF 2.0 (.gltf, buffers embedded) in millimeters.
Result<void> writeGltf(const anatomy::Surface& surface, const std::string& title,
                       const std::filesystem::path& file);

}  // namespace perilymph::imaging
