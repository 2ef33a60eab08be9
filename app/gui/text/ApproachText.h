// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The angles of an approach to the basal turn, in the user's language.

#include <QString>

#include "perilymph/anatomy/Approach.h"

namespace perilymph::gui {

/// "5.0° toward the lateral wall", where the array points in the plane of the basal turn; "0.0°" along the
/// axis of the opening.
QString inPlaneText(const anatomy::BasalTurnAngles& angles);
/// "3.0° toward the basilar membrane", the same out of that plane.
QString outOfPlaneText(const anatomy::BasalTurnAngles& angles);
/// Both: "5.0° toward the lateral wall in the plane of the basal turn, 3.0° toward the basilar membrane out
/// of it".
QString approachText(const anatomy::BasalTurnAngles& angles);

/// The limits of an approach, in a sentence.
QString approachLimitText();

}  // namespace perilymph::gui
