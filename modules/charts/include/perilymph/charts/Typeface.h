#pragma once

// The font of all text drawn by VTK.

class vtkTextProperty;

namespace perilymph::charts {

/// Sets Inter: the shipped file, else the system's, else DejaVu Sans, else VTK's default sans
/// serif.
void setTypeface(vtkTextProperty& text);

}  // namespace perilymph::charts
