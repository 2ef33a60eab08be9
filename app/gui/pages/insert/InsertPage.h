// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The insertion page: panel, 3D view, charts, and bars.

#include <utility>

#include "gui/pages/Page.h"
#include "gui/pages/insert/InsertionPresenter.h"
#include "gui/report/ReportSending.h"

class QStackedWidget;

namespace perilymph::gui {

class BottomBar;
class BuildingNote;
class FrameLoop;
class InsertionController;
class InsertionViews;
class LoadingStage;
class ReplayControl;
class ReportSaving;
class ResultCard;
class SidePanel;

/// Shows an insertion, or a replay in its place, and passes on what the user does; it computes and
/// decides nothing.
class InsertPage : public Page {
  Q_OBJECT
public:
  InsertPage(InsertionController& insertion, QWidget* parent);
  ~InsertPage() override;

  /// Recordings and patients.
  Acceptance accepts(const std::filesystem::path& file) const override;
  void open(const std::filesystem::path& file) override;
  bool showsInsertion() const override { return true; }
  /// An insertion that began and has not ended.
  std::optional<Unfinished> unfinished() const override;
  void endUnfinished() override;
  /// Keys of a replay.
  bool takeKey(const QKeyEvent& event) override;
  /// Pauses motion, which is no longer visible.
  void onHidden() override;

  /// Removes the focus from the panel. False if it is not there.
  bool leavePanel();
  void togglePanel();
  /// Shows bone and landmarks in the picture, or hides them.
  void toggleLandmarks();
  /// Updates the display of the input device.
  void showInput() { presenter_.showInput(); }

  /// Where the CT of a series is, as far as it is open.
  void setCtPlaces(CtPlaces places) { ctPlaces_ = std::move(places); }

  /// This page is visible.
  bool isShown() const { return isVisibleTo(window()); }
  InsertionViews& views() { return *views_; }
  FrameLoop& frames() { return *frames_; }

Q_SIGNALS:
  /// The display was updated; emitted fifteen times a second while the insertion runs.
  void stateShown();
  void devicesRequested();
  /// The user requests a search of all saved patients, or a new one.
  void allPatientsRequested();
  void newPatientRequested();
  void compareRequested(const std::vector<std::filesystem::path>& files);

protected:
  void wheelEvent(QWheelEvent* event) override;

private:
  void layOut();
  void connectInsertion();
  void connectPanel();
  void connectBars();
  void connectResult();
  void showResult();
  void saveReport();
  void sendResult();
  void showReplay();
  void showInsertion();
  void step(double elapsed_s);
  void updateReadouts();
  void showState();

  InsertionController& insertion_;
  SidePanel* side_;
  InsertionViews* views_;
  BottomBar* bottom_;
  BuildingNote* building_;
  ResultCard* result_;
  LoadingStage* loading_;
  ReplayControl* replay_;
  ReportSaving* saving_;
  QStackedWidget* bars_;
  FrameLoop* frames_;
  InsertionPresenter presenter_;
  CtPlaces ctPlaces_;
};

}  // namespace perilymph::gui
