#pragma once

// Colors and sizes of the charts; the window's palette.

#include <vtkColor.h>

namespace perilymph::charts::style {

inline const vtkColor4ub panel{0x1A, 0x20, 0x26, 255};
inline const vtkColor4ub ground{0x12, 0x16, 0x1A, 255};
inline const vtkColor4ub gridLine{0x2A, 0x32, 0x3A, 255};
inline const vtkColor4ub zeroLine{0x55, 0x61, 0x6B, 255};
inline const vtkColor4ub text{0xE8, 0xEC, 0xEF, 255};
inline const vtkColor4ub quietText{0x93, 0xA1, 0xAC, 255};
inline const vtkColor4ub accent{0x45, 0xC4, 0xB0, 255};
inline const vtkColor4ub blue{0x56, 0xB4, 0xE9, 255};
inline const vtkColor4ub orange{0xE6, 0x9F, 0x00, 255};

inline constexpr int labelSize = 11;  ///< Pixels at pixel ratio 1.
inline constexpr float lineWidth = 2.0f;
inline constexpr float thinWidth = 1.2f;

}  // namespace perilymph::charts::style
