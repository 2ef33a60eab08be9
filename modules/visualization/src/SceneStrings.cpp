#include "perilymph/visualization/SceneStrings.h"

#include <utility>

namespace perilymph::visualization {

namespace {

SceneStrings& current()
{
  static SceneStrings text;
  return text;
}

}  // namespace

void setSceneStrings(SceneStrings strings) { current() = std::move(strings); }
const SceneStrings& sceneStrings() { return current(); }

}  // namespace perilymph::visualization
