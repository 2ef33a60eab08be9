// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/Background.h"

#include <QCoreApplication>
#include <QEvent>
#include <QRunnable>
#include <mutex>

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

  AnswerEvent(std::shared_ptr<std::atomic<bool>> isCanceled, std::function<void()> answer)
      : QEvent(kind()), isCanceled_(std::move(isCanceled)), answer_(std::move(answer))
  {
  }
  bool isCanceled() const { return *isCanceled_; }
  void answer() { answer_(); }

private:
  std::shared_ptr<std::atomic<bool>> isCanceled_;
  std::function<void()> answer_;
};

}  // namespace

struct Background::Mailbox {
  std::mutex mutex;
  Background* owner = nullptr;
};

class Background::Task : public QRunnable {
public:
  Task(std::shared_ptr<Mailbox> mailbox, std::shared_ptr<std::atomic<bool>> isCanceled,
       std::function<void(const std::atomic<bool>&)> work, std::function<void()> answer)
      : mailbox_(std::move(mailbox)),
        isCanceled_(isCanceled),
        work_(std::move(work)),
        answer_(std::make_unique<AnswerEvent>(std::move(isCanceled), std::move(answer)))
  {
  }

  void run() override
  {
    declareThread(ThreadRole::worker);
    if (*isCanceled_) return;
    work_(*isCanceled_);
    const std::lock_guard lock(mailbox_->mutex);
    if (mailbox_->owner != nullptr) QCoreApplication::postEvent(mailbox_->owner, answer_.release());
  }

private:
  std::shared_ptr<Mailbox> mailbox_;
  std::shared_ptr<std::atomic<bool>> isCanceled_;
  std::function<void(const std::atomic<bool>&)> work_;
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
  forget();
  {
    const std::lock_guard lock(mailbox_->mutex);
    mailbox_->owner = nullptr;
  }
  if (thread_->waitForDone(patience_ms)) return;
  anyThreadLeft = true;
  static_cast<void>(thread_.release());  // its destructor would wait forever
}

void Background::start(std::function<void(const std::atomic<bool>&)> work,
                       std::function<void()> answer)
{
  forget();
  isCanceled_ = std::make_shared<std::atomic<bool>>(false);
  auto task = std::make_unique<Task>(mailbox_, isCanceled_, std::move(work), std::move(answer));
  isBusy_ = true;
  thread_->start(task.release());  // takes ownership
}

void Background::customEvent(QEvent* event)
{
  if (event->type() != AnswerEvent::kind()) return;
  auto& answered = static_cast<AnswerEvent&>(*event);
  if (answered.isCanceled()) return;
  isBusy_ = false;
  answered.answer();
}

void Background::finish()
{
  if (!isBusy_) return;
  thread_->waitForDone();
  QCoreApplication::sendPostedEvents(this, AnswerEvent::kind());
}

void Background::forget()
{
  if (isCanceled_) *isCanceled_ = true;
  isBusy_ = false;
}

bool Background::isAnyThreadLeft() { return anyThreadLeft; }

}  // namespace perilymph::gui
