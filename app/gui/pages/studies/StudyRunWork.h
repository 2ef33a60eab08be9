// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Estimates and runs studies off the window's thread.

#include <QObject>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <memory>

#include "gui/pages/studies/StudyStore.h"
#include "gui/run/Background.h"
#include "perilymph/study/StudyEstimate.h"

namespace perilymph::gui {

/// Runs one study at a time. Whole blocks of insertions are kept, whatever ends it.
class StudyRunWork : public QObject {
  Q_OBJECT
public:
  explicit StudyRunWork(QObject* parent);

  /// Saves a study in its folder and runs it there, or continues it.
  void start(const StudyDraft& draft, unsigned jobs);
  /// Continues a study in its folder with the settings there.
  void resume(const std::filesystem::path& folder, unsigned jobs);
  /// Asks the run to end; it answers ended().
  void requestStop() { background_.requestStop(); }
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  /// Emitted a few times a second.
  /// @param left_s  Time left at the rate of this run; negative while it is not known.
  void progressed(std::size_t done, std::size_t all, double left_s);
  /// The study is complete and merged, or was stopped.
  void ended(const perilymph::gui::StoredStudy& study);
  void failed(const QString& sentence);

private:
  using Clock = std::chrono::steady_clock;
  /// Messages of the working thread.
  struct Shared {
    std::atomic<std::size_t> done{0}, all{0};
  };
  template <class Folder>
  void run(Folder folder, unsigned jobs);
  void report();

  std::shared_ptr<Shared> shared_;
  Clock::time_point begin_;
  std::size_t first_ = 0;  ///< Insertions of earlier runs.
  bool isCounting_ = false;
  QTimer timer_;
  Background background_;
};

/// Checks drafts and measures what they cost. Of several only the last is answered.
class StudyEstimateWork : public QObject {
  Q_OBJECT
public:
  explicit StudyEstimateWork(QObject* parent) : QObject(parent), background_(this) {}

  void check(const StudyDraft& draft);
  void cancel() { background_.cancel(); }

Q_SIGNALS:
  void estimated(const perilymph::study::StudyEstimate& cost, std::size_t insertions);
  void refused(const QString& sentence);

private:
  Background background_;
};

}  // namespace perilymph::gui
