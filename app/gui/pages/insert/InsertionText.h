// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts about an insertion: the status line, the hint at the bottom of the 3D view, and the banner.

#include <QString>

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

/// @param device           Report rate of the device as text; empty without one.
/// @param framesPerSecond  Measured frame rate.
QString statusText(const InsertionControl& control, const QString& device, int framesPerSecond);

/// Error and remedy; empty if there is no error.
/// @param error  An error of the window itself; shown unless the loop has stopped.
QString errorText(const InsertionControl& control, const QString& error);

/// Possible next actions; empty if no hint is needed.
QString hintText(const InsertionControl& control);
QString buildingHint(bool isStartAsked);

/// "no stylet", "in", "3.0 mm out".
QString styletText(const InsertionControl& control);

}  // namespace perilymph::gui
