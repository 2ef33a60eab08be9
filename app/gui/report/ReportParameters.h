// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Parameters of a scenario in words with units, for the appendix of a report.

#include <QString>
#include <utility>
#include <vector>

#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// Name and value of every parameter that affects the result, in the order of a methods section.
std::vector<std::pair<QString, QString>> parametersOf(const session::Scenario& scenario);

}  // namespace perilymph::gui
