// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How an insertion ended: the first line of its results.

#include <QStringList>

#include "gui/report/InsertionResults.h"
#include "gui/report/ReportContent.h"
#include "perilymph/haptics/InsertionEnd.h"

namespace perilymph::gui {

/// "Buckled in front of the opening", "Full depth", "Withdrawn".
///
/// @param isAtDepth  It came to the stop travel of its scenario.
QString outcomeText(haptics::InsertionEnd end, bool isAtDepth, const session::Scenario& scenario);

/// The same in one or two words, for lists: "buckled", "stop reached".
QString outcomeWord(haptics::InsertionEnd end);

/// Where the results are from, and where the array lies at the end, if it is not as deep by more than half a
/// millimeter; else empty.
QStringList deepestNotes(const ReportContent& content);

/// "A hand that stops at 100 mN".
QString passedStopName(const analysis::PassedStop& passed);
/// "would have ended at 14.2 mm, 410°, 7 of 12 contacts inside".
QString passedStopText(const analysis::PassedStop& passed);

/// The outcome as a result, with what makes the others doubtful.
InsertionResult outcomeOf(const ReportContent& content);

}  // namespace perilymph::gui
