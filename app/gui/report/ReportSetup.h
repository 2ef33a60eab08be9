// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What an insertion rests on, in a line each: friction, and the landmarks of the CT.

#include <QString>

#include "gui/report/References.h"
#include "gui/report/ReportContent.h"

namespace perilymph::gui {

/// "0.165; Estimate from pig tissue [4]": the coefficient of the insertion, and its origin.
QString frictionText(const session::Scenario& scenario, References& references);

/// "0.08 to 0.33 (95 %)": the coefficients of ears, of which the insertion has the median; empty where the
/// friction's file states no spread.
QString frictionInEars(const session::Scenario& scenario);

/// "automatic", "moved by hand: RW; else automatic"; "entered" for measures without a CT, "not known"
/// where no saved patient has these measures.
QString landmarksText(const ReportContent& content);

}  // namespace perilymph::gui
