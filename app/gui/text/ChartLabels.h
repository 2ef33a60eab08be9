// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts of charts and 3D view, in the window's language.

#include <QString>
#include <string>

#include "perilymph/charts/ChartStyle.h"
#include "perilymph/visualization/SceneStyle.h"

namespace perilymph::gui {

/// A color scheme and the current language, for charts and scenes made now.
charts::ChartStyle chartStyle(figures::ColorScheme scheme);
visualization::SceneStyle sceneStyle(figures::ColorScheme scheme, double textScale = 1.0);

/// The translated name of a reference, or its label if there is no translation.
QString referenceName(const std::string& label);

}  // namespace perilymph::gui
