#pragma once

// How a scene looks and what its scales say, given to it when it is made.

#include <string>

#include "perilymph/figures/Style.h"

namespace perilymph::visualization {

/// Texts of the scales, English by default. %1 and %2 stand for numbers.
struct SceneStrings {
  std::string wallForce = "wall force, mN per mm";
  std::string normalForce = "normal force, %1 mm for %2 mN";
  std::string friction = "friction, × %1";
  char decimalSign = '.';
};

struct SceneStyle {
  figures::ColorScheme scheme = figures::ColorScheme::dark;
  SceneStrings strings;
};

}  // namespace perilymph::visualization
