// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Who issues a report: optional lines and the logo, from the user's settings.

#include <QImage>
#include <QString>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Institution, operator and logo of reports; empty where not set.
struct ReportIssuer {
  QString institution, operatorName;
  QImage logo;

  /// As set by the user. A logo that cannot be read is left out, with a warning in the log.
  static ReportIssuer fromSettings();
};

/// Reads a logo: PNG or JPEG, at most 4096 pixels wide and high.
Result<QImage> readLogo(const QString& file);

/// A UTC time in ISO format as local time, with its offset from UTC.
QString localTimeOf(const std::string& utc);

}  // namespace perilymph::gui
