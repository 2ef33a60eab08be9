#include "LibraryWork.h"

#include <QElapsedTimer>

#include "perilymph/foundation/RealTime.h"

namespace perilymph::gui {

namespace {

constexpr int reportInterval_ms = 100;

}  // namespace

LibraryWork::LibraryWork(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }

LibraryWork::~LibraryWork()
{
  cancel();
  thread_.waitForDone();
}

void LibraryWork::cancel()
{
  if (isCanceled_) *isCanceled_ = true;
}

void LibraryWork::list(const std::filesystem::path& folder,
                       const std::filesystem::path& beingRecorded)
{
  cancel();
  isCanceled_ = std::make_shared<std::atomic<bool>>(false);
  isBusy_ = true;
  const int request = ++request_;
  thread_.start([this, folder, beingRecorded, request, isCanceled = isCanceled_] {
    registerThreadRole(ThreadRole::worker);
    QElapsedTimer sinceReport;
    sinceReport.start();
    auto sessions =
        session::listSessions(folder, beingRecorded, [&](std::size_t done, std::size_t all) {
          if (sinceReport.elapsed() >= reportInterval_ms) {
            sinceReport.restart();
            QMetaObject::invokeMethod(
                this,
                [this, request, done, all] {
                  if (request == request_) Q_EMIT progressed(int(done), int(all));
                },
                Qt::QueuedConnection);
          }
          return !*isCanceled;
        });
    QMetaObject::invokeMethod(
        this,
        [this, request, sessions = std::move(sessions)] {
          if (request != request_) return;
          isBusy_ = false;
          if (sessions) return listed(*sessions);
          failed(QString::fromStdString(sessions.error().message));
        },
        Qt::QueuedConnection);
  });
}

}  // namespace perilymph::gui
