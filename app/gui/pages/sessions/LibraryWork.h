// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lists recordings in the background, because there may be thousands.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "gui/run/Background.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

/// Lists a folder in a separate thread and reports intermediate results, so that a slow or blocked
/// recording does not hide others. Of several requests only the last one is answered.
class LibraryWork : public QObject {
  Q_OBJECT
public:
  /// Lists a folder, like session::listSessions.
  using Lister = std::function<Result<std::vector<session::SessionSummary>>(
      const std::filesystem::path& folder, const std::filesystem::path& beingRecorded,
      const session::LibraryProgress& progress, const session::LibraryEntry& listed,
      const std::stop_token& stop)>;

  /// Time for a canceled listing to end; then its intermediate result is the answer.
  static constexpr int patience_ms = 500;

  explicit LibraryWork(QObject* parent, Lister lister = session::listSessions);

  void list(const std::filesystem::path& folder, const std::filesystem::path& beingRecorded);
  /// Ends the listing early, with what was read.
  void cancel();
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  /// Emitted several times a second while reading.
  /// @param fresh  Recordings read since the last time.
  void progressed(int done, int all, const std::vector<perilymph::session::SessionSummary>& fresh);
  /// @param all  Total number; more than listed if canceled.
  void listed(const std::vector<perilymph::session::SessionSummary>& sessions, int all);
  void failed(const QString& sentence);

private:
  struct Reading;

  void report();

  Lister lister_;
  std::shared_ptr<Reading> reading_;            ///< Shared with the thread.
  std::vector<session::SessionSummary> sofar_;  ///< Read up to the last report.
  QElapsedTimer sinceCancel_;                   ///< Valid after cancellation.
  QTimer timer_;
  Background background_;
};

}  // namespace perilymph::gui
