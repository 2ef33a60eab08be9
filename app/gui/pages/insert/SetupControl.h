// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Builds the cochlea and the model of a changed setup.

#include <QObject>
#include <functional>
#include <optional>

#include "gui/run/InsertionControl.h"
#include "gui/run/ModelBuilder.h"
#include "gui/setup/SetupHistory.h"

namespace perilymph::gui {

/// Owns the setup with its history and builds what it requires, in the background.
class SetupControl : public QObject {
  Q_OBJECT
public:
  /// Begins to build the parts of the first insertion.
  SetupControl(const InsertionControl& control, QObject* parent);

  /// The parts of the first insertion, which is prepared now; empty if they cannot be built.
  std::optional<InsertionControl::Parts> takeFirst();

  SetupHistory& history() { return *history_; }
  const SetupHistory& history() const { return *history_; }

  /// Makes a change. @return A message about dependent values; empty if there is none.
  QString change(const SetupChange& change);
  /// Updates the insertion to the current setup: emits ready() when everything is built, at once if
  /// nothing has to be.
  void follow();
  /// Builds another scenario and calls `use` with its parts; the caller starts its history.
  void build(const session::Scenario& scenario,
             std::function<void(const InsertionControl::Parts&)> use);
  /// Restores the displayed setup and cancels building. False if nothing was being built.
  bool cancel();
  /// Cancels building; the setup is kept.
  void abandon();

  bool isBuilding() const { return builder_.isBusy(); }
  qint64 buildingFor_ms() const { return builder_.busyFor_ms(); }

  /// Starts the insertion when building has finished.
  void startWhenBuilt(bool isRequested) { isStartRequested_ = isRequested; }
  bool isStartRequested() const { return isStartRequested_; }

Q_SIGNALS:
  /// A new scenario applies to the next insertions.
  /// @param parts  Its parts; empty if the model is unchanged.
  void ready(const perilymph::session::Scenario& scenario,
             const std::optional<perilymph::gui::InsertionControl::Parts>& parts);
  /// The setup is the displayed one, or is being built.
  void followed();
  void failed(const QString& sentence);

private:
  void giveUp();

  const InsertionControl& control_;
  SetupHistory* history_;
  std::optional<InsertionControl::Parts> first_;
  ModelBuilder firstBuilder_, builder_;
  bool isStartRequested_ = false;
};

}  // namespace perilymph::gui
