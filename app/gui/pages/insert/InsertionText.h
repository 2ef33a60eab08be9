// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts about an insertion: the status line, the hint at the bottom of the 3D view, and the banner.

#include <QString>

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

/// How an insertion that is over has ended, as a heading: "Full depth".
QString endTitle(const InsertionControl& control);

/// @param device  Report rate of the device as text; empty without one.
QString statusText(const InsertionControl& control, const QString& device);

/// "1000 Hz · late samples: 3 · 60 fps": timing of the haptic loop and the window, for experts.
QString timingText(const InsertionControl& control, int framesPerSecond);

/// Error and remedy; empty if there is no error.
/// @param error  An error of the window itself; shown unless the loop has stopped.
QString errorText(const InsertionControl& control, const QString& error);

/// Where an insertion in progress is, and what is recorded if it is ended now.
QString inProgressText(const InsertionControl& control);

/// How the insertion ended before its stop travel, and what to do; empty if it did not.
QString endText(haptics::InsertionEnd end, const haptics::TickOutput& now);

/// Possible next actions; empty if no hint is needed.
QString hintText(const InsertionControl& control);
QString buildingHint(bool isStartRequested);

/// "no stylet", "in", "3.0 mm out".
QString styletText(const InsertionControl& control);

}  // namespace perilymph::gui
