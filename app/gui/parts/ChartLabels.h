#pragma once

// What the charts and the picture say, in the window's language.

#include <QString>
#include <string>

#include "perilymph/charts/ChartStyle.h"
#include "perilymph/visualization/SceneStyle.h"

namespace perilymph::gui {

/// Colors of the shown look and texts of the chosen language, for charts and scenes made now.
charts::ChartStyle chartStyle();
visualization::SceneStyle sceneStyle();

/// The name of a reference; as its file calls it where no translation is known.
QString referenceName(const std::string& label);

}  // namespace perilymph::gui
