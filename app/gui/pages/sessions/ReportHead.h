// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Who and when of a report: settings of the user, and the lines on every page.

#include <QString>

#include "gui/pages/sessions/ReportContent.h"

namespace perilymph::gui {

/// Optional lines of a report, from the settings; empty if not set.
struct ReportIssuer {
  QString institution, operatorName;

  static ReportIssuer fromSettings();
};

/// "Patient P-017 · left ear", or the anatomy if there is no patient.
QString subjectOf(const ReportContent& content);

/// A UTC time of a recording in local time, with its offset from UTC.
QString localTimeOf(const std::string& utc);

}  // namespace perilymph::gui
