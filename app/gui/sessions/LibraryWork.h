#pragma once

// Listing recordings takes a moment where there are thousands: not in the thread that draws.

#include <QObject>
#include <atomic>
#include <filesystem>
#include <memory>
#include <vector>

#include "Background.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

/// Lists a folder in a thread of its own. Of several requests only the last one is answered.
class LibraryWork : public QObject {
  Q_OBJECT
public:
  explicit LibraryWork(QObject* parent) : QObject(parent), background_(this) {}

  void list(const std::filesystem::path& folder, const std::filesystem::path& beingRecorded);
  /// Ends the reading early: what was read is listed.
  void cancel();
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  /// Some times a second while it reads.
  void progressed(int done, int all);
  /// @param all  How many there are; more than were listed if it was canceled.
  void listed(const std::vector<perilymph::session::SessionSummary>& sessions, int all);
  void failed(const QString& sentence);

private:
  Background background_;
  std::shared_ptr<std::atomic<bool>> isEnded_;  ///< Of the request that is being answered.
};

}  // namespace perilymph::gui
