// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Runs a validation in the background and reports intermediate results.

#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <optional>

#include "gui/run/Background.h"
#include "perilymph/validation/ValidationReport.h"

namespace perilymph::gui {

/// Input of a validation: the shipped experiment and its variability.
struct ValidationBasis {
  validation::ValidationRequest request;
  validation::ValidationReferences references;
};
Result<ValidationBasis> shippedBasis();

/// Runs validations, one at a time.
class ValidationWork : public QObject {
  Q_OBJECT
public:
  explicit ValidationWork(QObject* parent);

  void start(validation::ValidationRequest request);
  /// Ends it early; finished() is then emitted without a result.
  void cancel();
  bool isRunning() const { return background_.isBusy(); }

Q_SIGNALS:
  /// Emitted a few times a second.
  /// @param sofar  Mean and spread over the completed insertions; empty before the second.
  void progressed(int done, int all, const perilymph::validation::ValidationResult& sofar);
  void finished(const std::optional<perilymph::validation::ValidationResult>& result,
                const QString& error);

private:
  /// Data passed from the working threads to the UI thread.
  struct Shared {
    std::mutex mutex;
    std::vector<std::vector<double>> curves;
    std::size_t done = 0, all = 0;
  };

  void report();

  std::shared_ptr<Shared> shared_;
  bool wasCanceled_ = false;
  QTimer timer_;
  Background background_;  ///< Its thread starts those that insert.
};

}  // namespace perilymph::gui
