#pragma once

// Building a cochlea and an array's model takes some tenths of a second: not in the thread that
// draws.

#include <QElapsedTimer>
#include <functional>
#include <memory>

#include "gui/run/Background.h"
#include "gui/run/InsertionControl.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// Builds what an insertion runs in, beside the UI thread. Of several requests only the last one is
/// answered, and those before it are not built if they have not begun.
class ModelBuilder {
public:
  using Answer = std::function<void(const Result<InsertionControl::Parts>&)>;

  explicit ModelBuilder(QObject* parent) : background_(parent) {}

  /// Calls `answer` in the UI thread once everything is built or cannot be.
  /// @param anatomy  The scenario's cochlea if it is built already.
  void build(const session::Scenario& scenario,
             std::shared_ptr<const anatomy::ScalaTympani> anatomy, Answer answer);
  /// Nothing that was asked for is answered any more.
  void forget() { background_.forget(); }
  bool isBusy() const { return background_.isBusy(); }
  /// Since the request that is being built [ms]; 0 without one.
  qint64 busyFor_ms() const { return isBusy() ? since_.elapsed() : 0; }

private:
  Background background_;
  QElapsedTimer since_;
};

}  // namespace perilymph::gui
