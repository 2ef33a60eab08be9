// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/LibraryWork.h"

#include <mutex>
#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"

namespace perilymph::gui {

using session::SessionSummary;

namespace {

constexpr int reportInterval_ms = 100;

}  // namespace

/// Data passed from the thread to the UI thread.
struct LibraryWork::Reading {
  std::mutex mutex;  ///< Protects the following members.
  std::vector<SessionSummary> fresh;
  int done = 0, all = 0;
};

LibraryWork::LibraryWork(QObject* parent, Lister lister)
    : QObject(parent), lister_(std::move(lister)), background_(this)
{
  timer_.setInterval(reportInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &LibraryWork::report);
}

void LibraryWork::cancel()
{
  if (!isBusy() || sinceCancel_.isValid()) return;
  background_.requestStop();
  sinceCancel_.start();
}

void LibraryWork::list(const std::filesystem::path& folder,
                       const std::filesystem::path& beingRecorded)
{
  reading_ = std::make_shared<Reading>();
  sofar_.clear();
  sinceCancel_.invalidate();
  const auto work = [lister = lister_, folder, beingRecorded,
                     reading = reading_](const std::stop_token& stop) {
    const auto progress = [&](std::size_t done, std::size_t all) {
      const std::lock_guard lock(reading->mutex);
      reading->done = int(done);
      reading->all = int(all);
    };
    const auto add = [&](const SessionSummary& summary) {
      const std::lock_guard lock(reading->mutex);
      reading->fresh.push_back(summary);
    };
    return lister(folder, beingRecorded, progress, add, stop);
  };
  background_.run("The list of recordings", work,
                  [this](const Result<std::vector<SessionSummary>>& sessions) {
                    timer_.stop();
                    if (sessions) return listed(*sessions, reading_->all);
                    failed(dataText(sessions.error().message));
                  });
  timer_.start();
}

void LibraryWork::report()
{
  std::vector<SessionSummary> fresh;
  int done = 0, all = 0;
  {
    const std::lock_guard lock(reading_->mutex);
    fresh.swap(reading_->fresh);
    done = reading_->done;
    all = reading_->all;
  }
  sofar_.insert(sofar_.end(), fresh.begin(), fresh.end());
  if (!sinceCancel_.isValid() || sinceCancel_.elapsed() < patience_ms)
    return progressed(done, all, fresh);
  // A file blocks its reader: do not wait for it.
  timer_.stop();
  background_.cancel();
  listed(sofar_, all);
}

}  // namespace perilymph::gui
