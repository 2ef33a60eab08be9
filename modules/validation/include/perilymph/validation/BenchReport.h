// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Output of the chain from bench to ear.

#include <string>

#include "perilymph/figures/Figure.h"
#include "perilymph/validation/BenchChain.h"

namespace perilymph::validation {

/// `specimen, medium, friction, low95, high95`; fresh tissue over several specimens at the end.
std::string benchFrictionCsv(const BenchResult& result);
/// `specimen, medium, depth_mm, measured_mN, predicted_mN, low90_mN, high90_mN, inside`.
std::string benchPredictedCsv(const BenchResult& result);
/// `specimen, forces, capstan, constant_ratio`: logarithms of probability densities.
std::string benchScoresCsv(const BenchResult& result);

/// The posteriors of the friction of every medium in the first specimen.
figures::Figure benchFrictionFigure(const BenchResult& result);

}  // namespace perilymph::validation
