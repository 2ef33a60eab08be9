#pragma once

// Listing recordings takes a moment where there are thousands: not in the thread that draws.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "gui/run/Background.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

/// Lists a folder in a thread of its own, and shows what it has read so far: a recording that takes
/// long, or never ends, hides no other. Of several requests only the last one is answered.
class LibraryWork : public QObject {
  Q_OBJECT
public:
  /// Lists a folder as session::listSessions does.
  using Lister = std::function<Result<std::vector<session::SessionSummary>>(
      const std::filesystem::path& folder, const std::filesystem::path& beingRecorded,
      const session::LibraryProgress& progress, const session::LibraryEntry& listed)>;

  /// Time a canceled listing has to end by itself; then what it has read is its answer.
  static constexpr int patience_ms = 500;

  explicit LibraryWork(QObject* parent, Lister lister = session::listSessions);

  void list(const std::filesystem::path& folder, const std::filesystem::path& beingRecorded);
  /// Ends the reading early: what was read is listed.
  void cancel();
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  /// Some times a second while it reads.
  /// @param fresh  What was read since the last time.
  void progressed(int done, int all, const std::vector<perilymph::session::SessionSummary>& fresh);
  /// @param all  How many there are; more than were listed if it was canceled.
  void listed(const std::vector<perilymph::session::SessionSummary>& sessions, int all);
  void failed(const QString& sentence);

private:
  struct Reading;

  void report();

  Lister lister_;
  std::shared_ptr<Reading> reading_;            ///< Shared with the thread.
  std::vector<session::SessionSummary> sofar_;  ///< Read until the last report.
  QElapsedTimer sinceCancel_;                   ///< Valid once it was canceled.
  QTimer timer_;
  Background background_;
};

}  // namespace perilymph::gui
