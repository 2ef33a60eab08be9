// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Colors and texts of a scene, given to it when it is made.

#include <string>

#include "perilymph/figures/Palette.h"

namespace perilymph::visualization {

/// Texts of the scales, English by default. %1 and %2 are placeholders of numbers.
struct SceneStrings {
  std::string wallForce = "wall force, mN per mm";
  std::string normalForce = "contact force (arrow %1 mm = %2 mN)";
  std::string friction = "friction force (arrows enlarged %1×)";
  char decimalSign = '.';
};

struct SceneStyle {
  figures::ColorScheme scheme = figures::ColorScheme::dark;
  SceneStrings strings;
  double textScale =
      1.0;  ///< Size of the scales and their texts, 12 pixels at 1 and InsertionScene::setScale(1).
  bool hasForceScale = true;  ///< The scale of the wall's force, in millinewtons per millimeter.
};

}  // namespace perilymph::visualization
