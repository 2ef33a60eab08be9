// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The program's font for text drawn by VTK.

#include <vtkTextProperty.h>

#include "perilymph/figures/Typeface.h"

namespace perilymph::charts {

/// Sets Inter, or VTK's default sans serif if its file is missing.
inline void setTypeface(vtkTextProperty& text)
{
  const std::string& file = figures::typefaceFile();
  if (file.empty()) {
    text.SetFontFamilyToArial();
    return;
  }
  text.SetFontFamily(VTK_FONT_FILE);
  text.SetFontFile(file.c_str());
}

}  // namespace perilymph::charts
