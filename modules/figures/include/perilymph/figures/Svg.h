#pragma once

// Drawings as SVG files.

#include <string>

#include "perilymph/figures/Drawing.h"

namespace perilymph::figures {

/// The drawing as an SVG file. Holds no date and no name of a machine: the same drawing gives the
/// same bytes.
std::string svg(const Drawing& drawing);

}  // namespace perilymph::figures
