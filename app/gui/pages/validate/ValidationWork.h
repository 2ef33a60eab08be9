#pragma once

// A validation beside the thread that draws, and what is known of it so far.

#include <QObject>
#include <QTimer>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include "gui/run/Background.h"
#include "perilymph/analysis/ValidationReport.h"

namespace perilymph::gui {

/// Everything a validation starts from: the shipped experiment and how it varied.
struct ValidationBasis {
  analysis::ValidationRequest request;
  analysis::ValidationReferences references;
};
Result<ValidationBasis> shippedBasis();

/// Runs validations one at a time.
class ValidationWork : public QObject {
  Q_OBJECT
public:
  explicit ValidationWork(QObject* parent);

  void start(analysis::ValidationRequest request);
  /// Ends it early; finished() then comes without a result.
  void cancel();
  bool isRunning() const { return background_.isBusy(); }

Q_SIGNALS:
  /// A few times a second while it runs.
  /// @param sofar  Mean and spread over the insertions that have ended; empty before the second.
  void progressed(int done, int all, const perilymph::analysis::ValidationResult& sofar);
  void finished(const std::optional<perilymph::analysis::ValidationResult>& result,
                const QString& error);

private:
  /// What the working threads leave for the UI thread.
  struct Shared {
    std::atomic<bool> isCanceled{false};
    std::mutex mutex;
    std::vector<std::vector<double>> curves;
    std::size_t done = 0, all = 0;
  };

  void report();

  std::shared_ptr<Shared> shared_;
  QTimer timer_;
  Background background_;  ///< Its thread spawns those that insert.
};

}  // namespace perilymph::gui
