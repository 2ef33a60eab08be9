// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The stop travel of an insertion in relation to the length of its array.

#include <QString>

#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// Maximum stop travel of an array, rounded to a micrometer, so that start depth and stop travel
/// together do not exceed the insertable length.
Length deepestStop(const electrode::ArrayDesign& array, Length startInside);

/// Insertable length that stays outside at the stop travel; 0 for a full insertion.
Length outsideAtStop(const session::Scenario& scenario);

/// "full insertion", or how much of the array stays outside.
QString stopText(const session::Scenario& scenario);

/// Message after a change of the array that changed the stop travel, too; empty if it did not.
QString stopChangeText(const session::Scenario& before, const session::Scenario& after);

}  // namespace perilymph::gui
