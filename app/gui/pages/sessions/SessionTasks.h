// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Background tasks of a recording: reading its curve as a reference run, writing its report.

#include <QObject>
#include <filesystem>
#include <functional>
#include <string>

#include "gui/report/ReportContent.h"
#include "gui/report/ReportSaving.h"
#include "gui/run/Background.h"
#include "gui/run/ReferenceInsertion.h"

namespace perilymph::gui {

/// Runs one task at a time and reports its progress.
class SessionTasks : public QObject {
  Q_OBJECT
public:
  explicit SessionTasks(QObject* parent);

  /// Reads the force-travel curve; emits referenceRead().
  void readReference(const std::filesystem::path& file);
  /// Writes the report of a recording.
  void writeReportOf(const std::filesystem::path& file, const ReportPlace& place);
  /// Makes the PDF of a recording's report for an archive; reportPrepared() has it.
  void prepareReportOf(const std::filesystem::path& file);

Q_SIGNALS:
  void said(const QString& sentence, bool isError);
  void referenceRead(const perilymph::gui::ReferenceInsertion& reference);
  void reportWritten(const std::filesystem::path& report, const QString& sentence);
  void reportPrepared(const std::string& pdf, const perilymph::gui::ReportIdentity& identity);

private:
  /// Replays a recording, and gives what its report states to `then` in the window's thread.
  void gather(const std::filesystem::path& file, std::function<void(const ReportContent&)> then);

  Background reading_;
  ReportSaving saving_;
};

}  // namespace perilymph::gui
