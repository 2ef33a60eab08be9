// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where a CT comes from: a folder, a file, the archive, one that was opened before; and its series.

#include <QString>
#include <QWidget>
#include <filesystem>
#include <string>

#include "gui/setup/CtRequest.h"

namespace perilymph::gui {

class CtSeriesList;

/// The buttons that open a CT, with their dialogs, and the list of its series.
class CtSource : public QWidget {
  Q_OBJECT
public:
  /// @param place  Begins the names of its objects where a window has two of it.
  explicit CtSource(QWidget* parent, const QString& place = {});

  CtSeriesList& series() { return *series_; }
  /// The next CT is looked for beside this one. That is not kept in the settings: such folders often
  /// bear patients' names.
  void remember(const std::filesystem::path& path);
  /// Asks for a folder or a file; opened() has it.
  void askFolder();
  void askFile();

Q_SIGNALS:
  void opened(const std::filesystem::path& path);
  void archiveRequested();
  /// One of the CTs that were opened last.
  void recentRequested(const perilymph::gui::CtRequest& request);
  void seriesChosen(const std::string& uid);

private:
  QString folder_;
  CtSeriesList* series_;
};

}  // namespace perilymph::gui
