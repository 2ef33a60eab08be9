// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Builds cochlea and model in the background, because it takes some tenths of a second.

#include <QElapsedTimer>
#include <functional>
#include <memory>
#include <utility>

#include "gui/run/Background.h"
#include "gui/run/CochleaStore.h"
#include "gui/run/InsertionControl.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// Builds the parts of an insertion in the background. Of several requests only the last one is
/// answered; earlier ones that have not begun are not built.
class ModelBuilder {
public:
  using Answer = std::function<void(const Result<InsertionControl::Parts>&)>;

  ModelBuilder(std::shared_ptr<CochleaStore> cochleae, QObject* parent)
      : cochleae_(std::move(cochleae)), background_(parent)
  {
  }

  /// Calls `answer` in the UI thread when everything is built or failed.
  /// @param anatomy  The scenario's cochlea if already built.
  void build(const session::Scenario& scenario,
             std::shared_ptr<const anatomy::ScalaTympani> anatomy, Answer answer);
  /// Waits for what is being built and calls its answer.
  void finish() { background_.finish(); }
  /// Cancels all requests.
  void cancel() { background_.cancel(); }
  bool isBusy() const { return background_.isBusy(); }
  /// Time since the current request [ms]; 0 without one.
  qint64 busyFor_ms() const { return isBusy() ? since_.elapsed() : 0; }

private:
  std::shared_ptr<CochleaStore> cochleae_;
  Background background_;
  QElapsedTimer since_;
};

}  // namespace perilymph::gui
