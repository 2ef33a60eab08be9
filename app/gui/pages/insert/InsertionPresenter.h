// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Display of an insertion on the page: 3D view, charts, buttons, and texts of the bars.

#include "gui/pages/insert/GhostControl.h"
#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

class BottomBar;
class BuildingNote;
class FrameMeter;
class InsertionController;
class InsertionViews;
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

  InsertionPresenter(InsertionController& insertion, Zones zones);

  /// Shows another cochlea or array.
  void showCochlea();
  /// Shows a new insertion with the array at its start.
  void showPrepared();
  /// Takes the newest snapshot; draws it only if it differs from the last one.
  void step();
  /// Updates numbers and flat views, fifteen times a second.
  void updateReadouts(const FrameMeter& meter);
  /// Updates buttons, bars, hint and banner.
  void showState(const FrameMeter& meter);
  void showInput();
  void showBanner();
  /// Shows the force expected by a plan, behind the insertions that it is for.
  void showPlan();
  /// Shows the reference insertion in chart, panel and 3D view, if there is one.
  void showReference();

private:
  void showButtons(const InsertionState& state);
  bool isNew(const haptics::Snapshot& now);

  InsertionController& insertion_;
  InsertionControl& control_;
  Zones zones_;
  GhostControl ghost_;
  haptics::Snapshot drawn_{};  ///< The snapshot shown in the scene.
};

}  // namespace perilymph::gui
