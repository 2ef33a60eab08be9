#include "LibraryWork.h"

#include <QElapsedTimer>

namespace perilymph::gui {

namespace {

constexpr int reportInterval_ms = 100;

/// What a folder holds.
struct Library {
  Result<std::vector<session::SessionSummary>> sessions;
  int all = 0;
};

}  // namespace

void LibraryWork::cancel()
{
  if (isEnded_) *isEnded_ = true;
}

void LibraryWork::list(const std::filesystem::path& folder,
                       const std::filesystem::path& beingRecorded)
{
  isEnded_ = std::make_shared<std::atomic<bool>>(false);
  const auto work = [this, folder, beingRecorded,
                     isEnded = isEnded_](const std::atomic<bool>& isCanceled) {
    QElapsedTimer sinceReport;
    sinceReport.start();
    int most = 0;
    auto sessions =
        session::listSessions(folder, beingRecorded, [&](std::size_t done, std::size_t all) {
          most = int(all);
          if (sinceReport.elapsed() >= reportInterval_ms) {
            sinceReport.restart();
            QMetaObject::invokeMethod(
                this,
                [this, isEnded, done, all] {
                  if (isEnded == isEnded_ && isBusy()) Q_EMIT progressed(int(done), int(all));
                },
                Qt::QueuedConnection);
          }
          return !isCanceled && !*isEnded;
        });
    return Library{std::move(sessions), most};
  };
  background_.run(work, [this](const Library& library) {
    if (library.sessions) return listed(*library.sessions, library.all);
    failed(QString::fromStdString(library.sessions.error().message));
  });
}

}  // namespace perilymph::gui
