#pragma once

// What the page says of an insertion: the status line, the hint at the foot of the picture, and the
// banner over it.

#include <QString>

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

/// @param device           How the device reports, in words; empty without one.
/// @param framesPerSecond  As drawn.
QString statusText(const InsertionControl& control, const QString& device, int framesPerSecond);

/// What went wrong and what to do; empty while all is well.
/// @param error  What the window itself could not do; said unless the loop has stopped.
QString errorText(const InsertionControl& control, const QString& error);

/// What can be done next; empty where nothing has to be said.
QString hintText(const InsertionControl& control);
QString buildingHint(bool isStartAsked);

/// "no stylet", "in", "3.0 mm out".
QString styletText(const InsertionControl& control);

}  // namespace perilymph::gui
