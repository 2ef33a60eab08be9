#pragma once

// What stands in the picture, in the language of whoever shows it.

#include <string>

namespace perilymph::visualization {

/// Words of the scales; English until others are set. %1 and %2 stand for numbers, which are
/// written with the decimal sign of the charts' wording.
struct SceneStrings {
  std::string wallForce = "wall force, mN per mm";
  std::string normalForce = "normal force, %1 mm for %2 mN";
  std::string friction = "friction, × %1";
};

/// Sets the strings of all scenes drawn from then on. Not while one is drawn in another thread.
void setSceneStrings(SceneStrings strings);
const SceneStrings& sceneStrings();

}  // namespace perilymph::visualization
