// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Checks of the display, before anything that would abort without it.

#include <QString>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Whether the X display can be reached. Call before QApplication, which aborts without one.
Result<void> probeDisplay();

/// Whether OpenGL 3.2 is available. Call after QApplication and before the first VTK widget, which
/// aborts without it.
Result<void> probeOpenGl();

/// Whether the display supports stereo buffers. Call after QApplication.
bool hasStereoBuffers();

/// Why quad-buffered stereo is unavailable; empty if it is available.
QString quadBufferedError(bool hasBuffers);

}  // namespace perilymph::gui
