// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Makes and opens plans off the window's thread.

#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

#include "gui/run/Background.h"
#include "gui/setup/PlanStore.h"

namespace perilymph::gui {

/// One plan at a time. Bands are shown after 8 draws, 16, 32 and so on; the last ones are those of
/// planning::makePlan() for the request.
class PlanWork : public QObject {
  Q_OBJECT
public:
  using SharedPlan = std::shared_ptr<const planning::Plan>;

  explicit PlanWork(QObject* parent);

  /// Makes a plan in its folder, or continues it there.
  void compute(const planning::PlanRequest& request);
  /// Shows the bands of a plan that was made before; computes no insertion.
  void open(const StoredPlan& plan);
  /// Ends the work. Whole blocks of draws are kept.
  void cancel();
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  /// Emitted a few times a second while a plan is computed.
  void progressed(std::size_t done, std::size_t all);
  /// Bands of the draws so far, or of all.
  void shown(const perilymph::gui::PlanWork::SharedPlan& plan,
             const perilymph::gui::StoredPlan& stored);
  /// The work ended; the sentence is empty if nothing went wrong.
  void ended(const QString& sentence);

private:
  /// What the working thread hands to the window's.
  struct Shared {
    std::mutex mutex;
    std::size_t done = 0, all = 0;
    SharedPlan plan;  ///< Not yet shown.
    StoredPlan stored;
  };

  static Result<void> make(Shared& shared, StoredPlan stored, const std::stop_token& stop);
  void report();

  std::shared_ptr<Shared> shared_;
  QTimer timer_;
  Background background_;
};

}  // namespace perilymph::gui
