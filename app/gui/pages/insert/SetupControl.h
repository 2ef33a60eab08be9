#pragma once

// From a change of the setup to the cochlea and the model that an insertion runs in.

#include <QObject>
#include <functional>
#include <optional>

#include "gui/run/InsertionControl.h"
#include "gui/run/ModelBuilder.h"
#include "gui/setup/SetupHistory.h"

namespace perilymph::gui {

/// Holds the setup with its history and builds what it asks for, beside the UI thread.
class SetupControl : public QObject {
  Q_OBJECT
public:
  SetupControl(const InsertionControl& control, QObject* parent);

  SetupHistory& history() { return *history_; }
  const SetupHistory& history() const { return *history_; }

  /// Brings the insertion in line with the history: ready() comes once what differs is built, at
  /// once where nothing has to be.
  void follow();
  /// Builds another scenario and calls `use` with its parts; the history is the caller's to begin.
  void build(const session::Scenario& scenario,
             std::function<void(const InsertionControl::Parts&)> use);
  /// Back to the setup that is shown; nothing is built any more.
  void cancel();
  /// Nothing is built any more; the setup stays as it is.
  void forget();

  bool isBuilding() const { return builder_.isBusy(); }
  qint64 buildingFor_ms() const { return builder_.busyFor_ms(); }

  /// The insertion starts once what is being built is there.
  void startWhenBuilt(bool isAsked) { isStartAsked_ = isAsked; }
  bool isStartAsked() const { return isStartAsked_; }

Q_SIGNALS:
  /// Insertions are of this scenario from now on.
  /// @param parts  Of the same model as before without any.
  void ready(const perilymph::session::Scenario& scenario,
             const std::optional<perilymph::gui::InsertionControl::Parts>& parts);
  /// The setup is the one that is shown, or is being built.
  void followed();
  void failed(const QString& sentence);

private:
  const InsertionControl& control_;
  SetupHistory* history_;
  ModelBuilder builder_;
  bool isStartAsked_ = false;
};

}  // namespace perilymph::gui
