// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Cochlear coverage that the literature reports with the best speech recognition.

#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// A band of coverage for orientation; it is no target.
struct CoverageReference {
  double low_percent = 0.0, high_percent = 0.0;
  std::string source, confidence;
};

/// The shipped band: resources/planning/coverage.toml.
Result<CoverageReference> coverageReference();

}  // namespace perilymph::gui
