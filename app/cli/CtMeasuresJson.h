// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "perilymph/ct/Measures.h"

namespace perilymph::cli {

/// What `ct measure --json` writes.
///
/// @param warnings  Sentences about the series.
std::string measuresJson(const ct::CochleaMeasures& measures,
                         const std::vector<std::string>& warnings, double seconds);

}  // namespace perilymph::cli
