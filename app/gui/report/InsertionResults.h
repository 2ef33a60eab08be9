// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The results of an insertion, as its report and the card at its end state them.

#include <QString>
#include <vector>

#include "gui/report/ReportContent.h"

namespace perilymph::gui {

struct InsertionResult {
  QString name, value, detail;  ///< The detail is the definition.
  QString plan;     ///< "57 (25–77) mN"; empty without a plan or where it has no such band.
  QString clinics;  ///< What clinics report of this array: "408 (373–449)°"; empty if nothing.
  QString clinicsDetail;           ///< With n, definition and source.
  bool isOutside = false;          ///< Outside of the plan's band.
  bool isHeadline = false;         ///< Stated on the card.
  bool isSentence = false;         ///< The value is words; the detail may have several lines.
  std::string clinicsSource = {};  ///< For References::label().
};

/// In reading order. A value that was not recorded is marked as such.
std::vector<InsertionResult> insertionResults(const ReportContent& content);

/// "ruptured at 183° by 62 mN", with the length above the partition if it went through.
QString ruptureText(const haptics::Translocation& found);

}  // namespace perilymph::gui
