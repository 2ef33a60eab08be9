#pragma once

// What is read from a recording beside the UI thread: its curve as a ghost, and its report.

#include <QObject>
#include <filesystem>
#include <utility>
#include <vector>

#include "gui/run/Background.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

/// Does one task at a time and says how it goes.
class SessionTasks : public QObject {
  Q_OBJECT
public:
  explicit SessionTasks(QObject* parent);

  /// Reads the curve of force over travel; ghostRead() follows.
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
