// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A, B and H of which a person entered some in place of those that were measured in a CT.

#include <string>
#include <vector>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::gui {

/// Names of the measures that a person entered in place of those from the CT: "A", "B", "H".
std::vector<std::string> enteredMeasures(const anatomy::Patient& patient);

/// Whether one of them, "A", "B" or "H", was.
bool isEntered(const anatomy::Patient& patient, const std::string& measure);

/// A patient with entered measures: each that is still that of the known patient, to what fields show,
/// keeps its error, and all of them keep their origin, whose software states which were entered:
/// "perilymph 0.3.0; entered: A". Another one has the assumed error, analysis::measuringError. If no
/// measure is the known patient's, none of this is kept.
anatomy::Patient withMeasuresOf(const anatomy::Patient& known, anatomy::Patient entered);

}  // namespace perilymph::gui
