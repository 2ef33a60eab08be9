// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Titles of setups, and what their insertion does.

#include <QString>

#include "gui/run/InsertionControl.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

class SetupHistory;

/// The patient and the ear, or the anatomy where there is no patient: "Patient P-017 · left ear".
QString subjectText(const session::Scenario& scenario);
/// The same where there is little room: "S-011 · right".
QString shortSubjectText(const session::Scenario& scenario);

/// The title of an insertion's setup: "P-017: FLEX28", or what differs from the preset.
QString setupTitle(const InsertionControl& control, const SetupHistory& setup);

/// The title, or empty if the insertion was not used yet.
QString currentWork(const InsertionControl& control, const SetupHistory& setup);

/// What an insertion does: "running".
QString progressText(Progress progress);

/// What its recording does: "recording now"; empty where nothing is recorded.
QString recordingText(Progress progress);

}  // namespace perilymph::gui
