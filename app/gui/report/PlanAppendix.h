// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The appendix of a plan's report. In this order: contacts, influences, distributions with their
// sources, traceability.

#include "gui/report/PlanReportContent.h"

namespace perilymph::gui {

/// The appendix as HTML, with all names escaped.
QString planAppendixText(const PlanReportContent& content);

}  // namespace perilymph::gui
