// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What an insertion rests on, in a line each: friction, and the landmarks of the CT.

#include <QString>

#include "gui/report/References.h"
#include "gui/report/ReportContent.h"

namespace perilymph::gui {

/// "0.165 (95 % 0.08–0.33); estimate from pig tissue [4]": coefficient, interval where the friction's
/// file states a spread, and origin.
QString frictionText(const session::Scenario& scenario, References& references);

/// "automatic", "moved by hand: RW; else automatic"; "entered" for measures without a CT, "not known"
/// where no saved patient has these measures.
QString landmarksText(const ReportContent& content);

}  // namespace perilymph::gui
