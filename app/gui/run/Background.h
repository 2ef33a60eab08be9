#pragma once

// Work that takes more than a moment, in a thread beside the one that draws.

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "perilymph/foundation/CallNoThrow.h"
#include "perilymph/foundation/RealTime.h"

namespace perilymph::gui {

/// Runs one piece of work at a time; of several requests only the last is answered. No exception
/// leaves the thread: it becomes the error of the work's Result. Called from the UI thread.
///
/// Work that does not end when it is canceled (a file that blocks its reader) holds up nobody: the
/// destructor waits for `patience_ms`, then leaves the thread alone.
class Background : public QObject {
  Q_OBJECT
public:
  static constexpr int patience_ms = 2000;

  explicit Background(QObject* parent);
  ~Background() override;

  /// Calls `work(const std::atomic<bool>& isCanceled)`, which returns a Result, in the other
  /// thread, then `answer` with that Result in this one. The work may outlive this object, and must
  /// not refer to it.
  ///
  /// @param subject  What is worked on, as a sentence about an exception begins: "The report".
  template <class Work, class Answer>
  void run(std::string subject, Work work, Answer answer)
  {
    using Given = std::invoke_result_t<Work&, const std::atomic<bool>&>;
    const auto given = std::make_shared<std::optional<Given>>();
    start(
        [given, subject = std::move(subject),
         work = std::move(work)](const std::atomic<bool>& isCanceled) mutable {
          *given = callNoThrow(subject, [&] { return work(isCanceled); });
        },
        [given, answer = std::move(answer)]() mutable { answer(std::move(**given)); });
  }

  /// Cancels the work; it is not answered.
  void forget();
  bool isBusy() const { return isBusy_; }

  /// Whether a thread was left running. The program must then end without its static destructors,
  /// which the thread may still need.
  static bool isAnyThreadLeft();

private:
  class Task;
  /// Where a thread leaves its answer; `owner` is null once nobody waits for one.
  struct Mailbox;

  void start(std::function<void(const std::atomic<bool>&)> work, std::function<void()> answer);
  void customEvent(QEvent* event) override;

  std::shared_ptr<Mailbox> mailbox_;
  std::unique_ptr<QThreadPool> thread_;  ///< One thread.
  std::shared_ptr<std::atomic<bool>> isCanceled_;
  bool isBusy_ = false;
};

}  // namespace perilymph::gui
