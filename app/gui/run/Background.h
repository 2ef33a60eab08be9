// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Runs long work in a background thread.

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <type_traits>
#include <utility>

#include "perilymph/foundation/CallNoThrow.h"
#include "perilymph/foundation/RealTime.h"

namespace perilymph::gui {

/// Runs one piece of work at a time; of several requests only the last is answered. An exception in
/// the thread becomes the error of the work's Result. Call from the UI thread.
///
/// Work that ignores cancellation (a blocked file) does not block the program: the destructor waits
/// for `patience_ms`, then abandons the thread.
class Background : public QObject {
  Q_OBJECT
public:
  static constexpr int patience_ms = 2000;

  explicit Background(QObject* parent);
  ~Background() override;

  /// Calls `work(const std::stop_token& stop)`, which returns a Result, in the background
  /// thread, then `answer` with that Result in this one. The work may outlive this object and must
  /// not refer to it.
  ///
  /// @param subject  Beginning of an error message for an exception: "The report".
  template <class Work, class Answer>
  void run(std::string subject, Work work, Answer answer)
  {
    using Given = std::invoke_result_t<Work&, const std::stop_token&>;
    const auto given = std::make_shared<std::optional<Given>>();
    start(
        [given, subject = std::move(subject),
         work = std::move(work)](const std::stop_token& stop) mutable {
          *given = callNoThrow(subject, [&] { return work(stop); });
        },
        [given, answer = std::move(answer)]() mutable { answer(std::move(**given)); });
  }

  /// Waits for the work and calls its answer. Does nothing without work.
  void finish();
  /// Asks the work to end early; it still answers.
  void requestStop() { stop_.request_stop(); }
  /// The same, without an answer.
  void cancel();
  bool isBusy() const { return isBusy_; }

  /// Whether a thread was abandoned. The program must then end without its static destructors,
  /// because the thread may still use them.
  static bool isAnyThreadLeft();

private:
  class Task;
  /// Receives the answers of the thread.
  struct Mailbox;

  void start(std::function<void(const std::stop_token&)> work, std::function<void()> answer);
  void customEvent(QEvent* event) override;

  std::shared_ptr<Mailbox> mailbox_;
  std::unique_ptr<QThreadPool> thread_;  ///< One thread.
  std::stop_source stop_;                ///< Ends the last work.
  std::uint64_t runs_ = 0;               ///< Number of works so far.
  bool isBusy_ = false;
};

}  // namespace perilymph::gui
