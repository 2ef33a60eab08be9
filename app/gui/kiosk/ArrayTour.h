// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The arrays that the booth's demonstration inserts in turn.

#include <QString>
#include <vector>

#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// The scenario of the booth, then the same with other arrays, straight and pre-curved ones. An array
/// that the scenario does not allow is left out.
std::vector<session::Scenario> arrayTour(const session::Scenario& booth);

/// What visitors see of a scenario's array, in plain words: whether it is straight or pre-curved, and
/// where in the cochlea it lies.
QString arraySentence(const session::Scenario& scenario);

}  // namespace perilymph::gui
