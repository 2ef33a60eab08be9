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

/// "automatic", "moved by hand: RW"; "none; entered by hand" for measures without a CT.
QString landmarksText(const anatomy::Patient& measured);

/// The same of an insertion's patient; "not known" where no saved patient has its measures.
QString landmarksText(const ReportContent& content);

}  // namespace perilymph::gui
