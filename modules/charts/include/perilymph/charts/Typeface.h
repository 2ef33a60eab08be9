#pragma once

// The one typeface of all that VTK writes.

class vtkTextProperty;

namespace perilymph::charts {

/// Sets Inter: the copy that ships with the program, else the system's, else DejaVu Sans, else
/// VTK's own sans serif.
void setTypeface(vtkTextProperty& text);

}  // namespace perilymph::charts
