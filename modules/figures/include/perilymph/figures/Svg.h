// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// SVG output of drawings.

#include <string>

#include "perilymph/figures/Drawing.h"

namespace perilymph::figures {

/// The drawing as an SVG file, without dates and host names: the same drawing gives the same bytes.
std::string svg(const Drawing& drawing);

}  // namespace perilymph::figures
