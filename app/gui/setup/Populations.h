// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Population statistics of each patient measure, with sources.

#include "gui/setup/PopulationField.h"

namespace perilymph::gui {

Population scalaLengthPopulation();
Population windowWidthPopulation();
Population windowHeightPopulation();
Population lengthAPopulation();
Population widthBPopulation();
Population heightHPopulation();

}  // namespace perilymph::gui
