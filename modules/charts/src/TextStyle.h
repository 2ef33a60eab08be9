#pragma once

// The program's typeface on texts that VTK writes.

#include <vtkTextProperty.h>

#include "perilymph/figures/Typeface.h"

namespace perilymph::charts {

/// Sets Inter, or VTK's own sans serif where no file of it is found.
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
