// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A CT from an archive: server, query, studies, series, retrieval.

#include <QElapsedTimer>
#include <QString>
#include <QTimer>
#include <QWidget>
#include <filesystem>
#include <vector>

#include "gui/archive/ArchiveWork.h"
#include "gui/archive/FetchedFolder.h"

class QProgressBar;
class QPushButton;

namespace perilymph::gui {

class ArchiveQuery;
class Selector;
class SeriesRows;
class StatusLine;
class StudyRows;

/// Asks an archive only when Find or Retrieve is pressed, or a study is chosen. Patients are shown
/// here alone; leave() clears them.
class ArchiveView : public QWidget {
  Q_OBJECT
public:
  /// @param place  Begins the names of its objects where a window has two of it.
  explicit ArchiveView(QWidget* parent, const QString& place = {});

  /// Reads the list of servers and waits for a query.
  void enter();
  /// Cancels a request, and empties fields and tables.
  void leave();
  /// Cancels a request. False if there was none.
  bool cancel();
  /// Reads the list of servers again.
  void showServers();
  bool isBusy() const { return work_.isBusy(); }
  ArchiveWork& work() { return work_; }

Q_SIGNALS:
  /// A series is in this folder, which is removed when the program ends.
  void fetched(const std::filesystem::path& folder);
  void leaveRequested();
  /// The list of servers is to be changed.
  void serversRequested();

private:
  void connectWork();
  void find();
  void findSeries();
  void fetch();
  void begin(const QString& task);
  void end(const QString& sentence, bool isError = false);
  void showState();
  const archive::Server* server() const;

  ArchiveWork work_;
  FetchedFolder folder_;
  std::vector<archive::Server> servers_;
  QString task_;
  QElapsedTimer since_;
  QTimer pause_;  ///< Before the series of a chosen study are asked for: rows are run through.
  Selector* server_;
  ArchiveQuery* query_;
  StudyRows* studies_;
  SeriesRows* series_;
  QPushButton *find_, *fetch_, *cancel_, *back_, *edit_;
  QProgressBar* progress_;
  StatusLine* status_;
};

}  // namespace perilymph::gui
