// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "perilymph/ct/Measures.h"

namespace perilymph::cli {

/// What `ct measure --json` writes.
///
/// @param warnings  Sentences about the series.
std::string measuresJson(const ct::CochleaMeasures& measures, const std::vector<Sentence>& warnings,
                         double seconds);

/// What it writes with `--side both`: "ears", the right one first, each as with one ear.
std::string measuresJson(const std::array<ct::CochleaMeasures, 2>& ears,
                         const std::vector<Sentence>& warnings, double seconds);

}  // namespace perilymph::cli
