#pragma once

// The quiet ground of the operation view: dark, a little lighter in the middle.

class vtkRenderer;

namespace perilymph::visualization {

/// Gives the renderer its background.
void setBackdrop(vtkRenderer& renderer);

}  // namespace perilymph::visualization
