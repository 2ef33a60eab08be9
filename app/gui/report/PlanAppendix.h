// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The appendix of a plan's report. In this order: contacts, distributions with their
// sources, traceability, references.

#include "gui/report/PlanReportContent.h"
#include "gui/report/References.h"

namespace perilymph::gui {

/// The appendix as HTML, with all names escaped.
///
/// @param references  Those of the record; they are listed at the end.
QString planAppendixText(const PlanReportContent& content, References& references);

}  // namespace perilymph::gui
