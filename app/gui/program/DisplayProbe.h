#pragma once

// Can a picture be shown here at all? Asked before anything that would abort if it cannot.

#include <QString>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Whether the X display can be reached. Before QApplication, which aborts without one.
Result<Done> probeDisplay();

/// Whether OpenGL 3.2 can be had. After QApplication, before the first VTK widget, which aborts
/// without it.
Result<Done> probeOpenGl();

/// What OpenGL calls itself here; empty if it cannot be had. After QApplication.
std::string openGlRenderer();

/// Whether the display has surfaces with a buffer for each eye. After QApplication.
bool hasStereoBuffers();

/// Why pictures for two eyes cannot go through two buffers of the display; empty where they can.
QString quadBufferedError(bool hasBuffers);

}  // namespace perilymph::gui
