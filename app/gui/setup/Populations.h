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

/// How to measure A, B and H in CT: the cochlear view (Xu et al. 2000, Escude et al. 2006) with the
/// coordinates of the consensus (Verbist et al. 2010, doi 10.1097/MAO.0b013e3181d279e0).
QString measuringOfA();
QString measuringOfB();
QString measuringOfH();
/// That a length is not visible in clinical CT.
QString notInClinicalCt();

}  // namespace perilymph::gui
