#pragma once

// Listing recordings takes a moment where there are thousands: not in the thread that draws.

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <filesystem>
#include <memory>
#include <vector>

#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

/// Lists a folder in a thread of its own. Of several requests only the last one is answered.
class LibraryWork : public QObject {
  Q_OBJECT
public:
  explicit LibraryWork(QObject* parent);
  ~LibraryWork() override;

  void list(const std::filesystem::path& folder, const std::filesystem::path& beingRecorded);
  void cancel();
  bool isBusy() const { return isBusy_; }

Q_SIGNALS:
  /// Some times a second while it reads.
  void progressed(int done, int all);
  void listed(const std::vector<perilymph::session::SessionSummary>& sessions);
  void failed(const QString& sentence);

private:
  QThreadPool thread_;  ///< One thread.
  std::shared_ptr<std::atomic<bool>> isCanceled_;
  int request_ = 0;
  bool isBusy_ = false;
};

}  // namespace perilymph::gui
