// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/Background.h"

#include <QCoreApplication>
#include <QEvent>
#include <QRunnable>
#include <mutex>
#include <stop_token>

namespace perilymph::gui {

namespace {

std::atomic<bool> anyThreadLeft{false};

/// Delivers an answer to the UI thread. Allocated before the work begins, so that it is available
/// when memory is exhausted.
class AnswerEvent : public QEvent {
public:
  static QEvent::Type kind()
  {
    static const int registered = QEvent::registerEventType();
    return QEvent::Type(registered);
  }

  AnswerEvent(std::uint64_t run, std::function<void()> answer)
      : QEvent(kind()), run_(run), answer_(std::move(answer))
  {
  }
  std::uint64_t run() const { return run_; }
  void answer() { answer_(); }

private:
  std::uint64_t run_;
  std::function<void()> answer_;
};

}  // namespace

struct Background::Mailbox {
  std::mutex mutex;
  Background* owner = nullptr;   ///< Null after its end.
  std::uint64_t awaitedRun = 0;  ///< Number of the work that is still to be answered; 0: none.

  void await(std::uint64_t run)
  {
    const std::lock_guard lock(mutex);
    awaitedRun = run;
  }
  bool awaits(std::uint64_t run)
  {
    const std::lock_guard lock(mutex);
    return awaitedRun == run;
  }
};

class Background::Task : public QRunnable {
public:
  Task(std::shared_ptr<Mailbox> mailbox, std::uint64_t run, std::stop_token stop,
       std::function<void(const std::stop_token&)> work, std::function<void()> answer)
      : mailbox_(std::move(mailbox)),
        run_(run),
        stop_(std::move(stop)),
        work_(std::move(work)),
        answer_(std::make_unique<AnswerEvent>(run, std::move(answer)))
  {
  }

  void run() override
  {
    declareThread(ThreadRole::worker);
    if (!mailbox_->awaits(run_)) return;
    work_(stop_);
    const std::lock_guard lock(mailbox_->mutex);
    if (mailbox_->owner != nullptr) QCoreApplication::postEvent(mailbox_->owner, answer_.release());
  }

private:
  std::shared_ptr<Mailbox> mailbox_;
  std::uint64_t run_;
  std::stop_token stop_;
  std::function<void(const std::stop_token&)> work_;
  std::unique_ptr<AnswerEvent> answer_;
};

Background::Background(QObject* parent)
    : QObject(parent),
      mailbox_(std::make_shared<Mailbox>()),
      thread_(std::make_unique<QThreadPool>())
{
  mailbox_->owner = this;
  thread_->setMaxThreadCount(1);
}

Background::~Background()
{
  cancel();
  {
    const std::lock_guard lock(mailbox_->mutex);
    mailbox_->owner = nullptr;
  }
  if (thread_->waitForDone(patience_ms)) return;
  anyThreadLeft = true;
  static_cast<void>(thread_.release());  // its destructor would wait forever
}

void Background::start(std::function<void(const std::stop_token&)> work,
                       std::function<void()> answer)
{
  cancel();
  stop_ = std::stop_source();
  auto task = std::make_unique<Task>(mailbox_, ++runs_, stop_.get_token(), std::move(work),
                                     std::move(answer));
  mailbox_->await(runs_);
  isBusy_ = true;
  thread_->start(task.release());  // takes ownership
}

void Background::customEvent(QEvent* event)
{
  if (event->type() != AnswerEvent::kind()) return;
  auto& answered = static_cast<AnswerEvent&>(*event);
  if (!isBusy_ || answered.run() != runs_) return;
  isBusy_ = false;
  answered.answer();
}

void Background::finish()
{
  if (!isBusy_) return;
  thread_->waitForDone();
  QCoreApplication::sendPostedEvents(this, AnswerEvent::kind());
}

void Background::cancel()
{
  stop_.request_stop();
  mailbox_->await(0);
  isBusy_ = false;
}

bool Background::isAnyThreadLeft() { return anyThreadLeft; }

}  // namespace perilymph::gui
