#pragma once

// How an insertion is shown on the page: picture, charts, buttons, and what the bars say.

#include <QString>

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

class BottomBar;
class BuildingNote;
class FrameMeter;
class InsertionViews;
class SetupControl;
class SidePanel;
struct InsertionState;

/// Pulls from the insertion, converts, and draws on the zones of the page.
class InsertionPresenter {
public:
  /// What it draws on.
  struct Zones {
    SidePanel* side;
    InsertionViews* views;
    BottomBar* bottom;
    BuildingNote* building;
  };

  InsertionPresenter(InsertionControl& control, const SetupControl& setup, Zones zones);

  /// Another cochlea or another array.
  void showCochlea();
  /// A fresh insertion with the array at its start.
  void showPrepared();
  /// Takes the newest picture; one that is like the last is not drawn.
  void step();
  /// Numbers and flat views, fifteen times a second.
  void stepSlowly(const FrameMeter& meter);
  /// Buttons, bars, hint and banner.
  ///
  /// @param maySetUp  The setup may be changed now.
  void showState(const FrameMeter& meter, bool maySetUp);
  void showInput();

  /// What went wrong, in place, until it is forgotten.
  void showError(const QString& sentence);
  void forgetError() { error_.clear(); }
  /// What the banner says; empty while all is well.
  QString error() const;

private:
  void showButtons(const InsertionState& state);
  bool isNew(const haptics::Snapshot& now);

  InsertionControl& control_;
  const SetupControl& setup_;
  Zones zones_;
  QString error_;
  haptics::Snapshot drawn_{};  ///< The picture the scene shows.
};

}  // namespace perilymph::gui
