#pragma once

// Work that takes more than a moment, beside the thread that draws.

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <memory>
#include <utility>

#include "perilymph/foundation/RealTime.h"

namespace perilymph::gui {

/// Runs one piece of work at a time. Of several asked for, only the last is answered. UI thread.
class Background : public QObject {
  Q_OBJECT
public:
  /// True once nobody waits for the work any more.
  using Canceled = std::shared_ptr<std::atomic<bool>>;

  explicit Background(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }
  ~Background() override
  {
    forget();
    thread_.waitForDone();
  }

  /// Calls `work(const std::atomic<bool>& isCanceled)` in the other thread, then `answer` with what
  /// it gave in this one.
  template <class Work, class Answer>
  void run(Work work, Answer answer)
  {
    forget();
    canceled_ = std::make_shared<std::atomic<bool>>(false);
    isBusy_ = true;
    thread_.start(
        [this, canceled = canceled_, work = std::move(work), answer = std::move(answer)]() mutable {
          registerThreadRole(ThreadRole::worker);
          // shared, because not everything that work gives can be copied
          auto given = std::make_shared<decltype(work(*canceled))>(work(*canceled));
          QMetaObject::invokeMethod(
              this,
              [this, canceled, given, answer = std::move(answer)]() mutable {
                if (*canceled) return;
                isBusy_ = false;
                answer(std::move(*given));
              },
              Qt::QueuedConnection);
        });
  }

  /// Nobody waits any more: the work is told, and not answered.
  void forget()
  {
    if (canceled_) *canceled_ = true;
    isBusy_ = false;
  }
  bool isBusy() const { return isBusy_; }

private:
  QThreadPool thread_;  ///< One thread.
  Canceled canceled_;
  bool isBusy_ = false;
};

}  // namespace perilymph::gui
