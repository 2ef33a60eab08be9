#pragma once

// What is known of each number of a patient over the population, with its source.

#include "gui/setup/PopulationField.h"

namespace perilymph::gui {

Population scalaLengthPopulation();
Population windowWidthPopulation();
Population windowHeightPopulation();
Population lengthAPopulation();
Population widthBPopulation();
Population heightHPopulation();

}  // namespace perilymph::gui
