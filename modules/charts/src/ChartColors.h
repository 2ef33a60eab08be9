// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Colors of VTK's charts.

#include <vtkColor.h>

#include "perilymph/figures/Palette.h"

namespace perilymph::charts {

inline vtkColor4ub colorOf(const figures::Ink& ink)
{
  return {ink.rgb[0], ink.rgb[1], ink.rgb[2],
          static_cast<unsigned char>(ink.opacity * 255.0 + 0.5)};
}

inline constexpr float lineWidth = 2.0f;
inline constexpr float thinWidth = 1.2f;

}  // namespace perilymph::charts
