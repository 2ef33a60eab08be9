#pragma once

// Building a cochlea takes some tenths of a second: not in the thread that draws.

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <memory>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// Builds cochleae in a thread of its own. Of several requests only the last one is answered.
class AnatomyWork : public QObject {
  Q_OBJECT
public:
  using Answer = std::function<void(Result<std::shared_ptr<const anatomy::ScalaTympani>>)>;

  explicit AnatomyWork(QObject* parent);
  ~AnatomyWork() override;

  /// Calls `answer` in the UI thread once the scenario's cochlea is built or cannot be.
  void build(const session::Scenario& scenario, Answer answer);
  /// Nothing that was asked for is answered any more.
  void forget();
  bool isBusy() const { return isBusy_; }

private:
  QThreadPool thread_;  ///< One thread.
  int request_ = 0;
  bool isBusy_ = false;
};

}  // namespace perilymph::gui
