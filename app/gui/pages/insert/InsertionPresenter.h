// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Display of an insertion on the page: 3D view, charts, buttons, and texts of the bars.

#include <QString>

#include "gui/pages/insert/GhostControl.h"
#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

class BottomBar;
class BuildingNote;
class FrameMeter;
class InsertionViews;
class SetupControl;
class SidePanel;
struct InsertionState;

/// Reads the insertion's state, converts it, and draws it on the parts of the page.
class InsertionPresenter {
public:
  /// The parts of the page.
  struct Zones {
    SidePanel* side;
    InsertionViews* views;
    BottomBar* bottom;
    BuildingNote* building;
  };

  InsertionPresenter(InsertionControl& control, const SetupControl& setup, Zones zones);

  /// Shows another cochlea or array.
  void showCochlea();
  /// Shows a new insertion with the array at its start.
  void showPrepared();
  /// Takes the newest snapshot; draws it only if it differs from the last one.
  void step();
  /// Updates numbers and flat views, fifteen times a second.
  void stepSlowly(const FrameMeter& meter);
  /// Updates buttons, bars, hint and banner.
  ///
  /// @param maySetUp  The setup may be changed now.
  void showState(const FrameMeter& meter, bool maySetUp);
  void showInput();
  /// Shows a reference insertion in chart, panel and 3D view, or none.
  /// Force expected by a plan, behind the insertions that it is for.
  void setPlan(const std::optional<PlannedForce>& plan);
  void setReference(const std::optional<ReferenceInsertion>& reference);

  /// Shows an error until it is cleared.
  void showError(const QString& sentence);
  void forgetError() { error_.clear(); }
  /// Text of the banner; empty if there is no error.
  QString error() const;

private:
  void showButtons(const InsertionState& state);
  bool isNew(const haptics::Snapshot& now);

  InsertionControl& control_;
  const SetupControl& setup_;
  Zones zones_;
  GhostControl ghost_;
  QString error_;
  haptics::Snapshot drawn_{};  ///< The snapshot shown in the scene.
};

}  // namespace perilymph::gui
