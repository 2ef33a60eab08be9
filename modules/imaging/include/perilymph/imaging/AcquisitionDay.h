// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// When a CT was made. The day is shown to the user; no file has it.

#include <string>

#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {

/// The day on which a listed series was acquired, the first of several: "2026-11-20". Where its files do not
/// state that, the day of the series or of the study; empty where they state none, as NIfTI and NRRD do.
///
/// @param uid  CtSeries::uid of the series.
std::string acquisitionDay(const CtSeriesList& list, const std::string& uid);

}  // namespace perilymph::imaging
