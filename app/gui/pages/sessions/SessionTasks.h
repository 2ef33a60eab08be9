// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Background tasks of a recording: reading its curve as a reference run, writing its report.

#include <QObject>
#include <filesystem>
#include <utility>
#include <vector>

#include "gui/run/Background.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

/// Runs one task at a time and reports its progress.
class SessionTasks : public QObject {
  Q_OBJECT
public:
  explicit SessionTasks(QObject* parent);

  /// Reads the force-travel curve; emits ghostRead().
  void readGhost(const std::filesystem::path& file);
  /// Writes a report as PDF.
  void writeReportOf(const std::filesystem::path& file, const std::filesystem::path& pdf);

Q_SIGNALS:
  void said(const QString& sentence, bool isError);
  void ghostRead(const std::vector<std::pair<perilymph::Length, perilymph::Force>>& curve,
                 const QString& name);

private:
  Background reading_;
};

}  // namespace perilymph::gui
