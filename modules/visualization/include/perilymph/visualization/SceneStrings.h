#pragma once

// Texts in the picture, translated by the user interface.

#include <string>

namespace perilymph::visualization {

/// Texts of the scales; English by default. %1 and %2 are placeholders of numbers, which have the
/// decimal sign of the charts' texts.
struct SceneStrings {
  std::string wallForce = "wall force, mN per mm";
  std::string normalForce = "normal force, %1 mm for %2 mN";
  std::string friction = "friction, × %1";
};

/// Sets the texts of all scenes drawn afterwards. Not while another thread draws a scene.
void setSceneStrings(SceneStrings strings);
const SceneStrings& sceneStrings();

}  // namespace perilymph::visualization
