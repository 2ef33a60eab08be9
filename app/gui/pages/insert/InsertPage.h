// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The insertion page: panel, 3D view, charts, bars, and user input.

#include <QWidget>
#include <filesystem>
#include <optional>

#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/HeldArray.h"
#include "gui/pages/insert/InsertionPresenter.h"
#include "gui/pages/insert/SetupControl.h"
#include "gui/run/InsertionControl.h"
#include "gui/run/ReferenceInsertion.h"
#include "gui/run/SafetyStop.h"
#include "perilymph/foundation/Result.h"

class QStackedWidget;

namespace perilymph::gui {

class BottomBar;
class BuildingNote;
class FrameLoop;
class InsertionViews;
class OperationView;
class ReplayControl;
class SidePanel;

/// Shows an insertion and requests its steps; it computes nothing. A recording can be replayed in
/// its place: then no loop runs and no device is open.
class InsertPage : public QWidget {
  Q_OBJECT
public:
  InsertPage(session::Scenario scenario, std::optional<std::filesystem::path> record,
             std::shared_ptr<CochleaStore> cochleae, QWidget* parent);
  ~InsertPage() override;

  /// Builds the cochlea and prepares the insertion; then frames begin.
  Result<Done> open();

  /// What follows after another scenario was loaded, whose cochlea is built meanwhile. The page
  /// will be shown.
  enum class AfterLoading { rest, insert };
  void load(const Setup& setup, SetupOrigin::Kind kind, AfterLoading then);
  /// What a new window with the same scenario continues.
  struct Memory {
    SetupHistory::Memory setup;
    std::optional<ReferenceInsertion> ghost;
    InputSource input = InputSource::scripted;
    InsertionControl::DeviceFactory device;
    std::optional<PlannedForce> plan = {};
  };
  Memory memory() const;
  /// Before open(), which uses the input.
  void resume(const Memory& memory);

  void start();
  /// Releases the array, which keeps its position.
  void pause();
  void withdraw();
  /// Prepares a new insertion with the array at its start and the same device.
  void reset();
  void pullStylet() { control_.pullStylet(); }
  void undo();
  void redo();

  /// Uses a device as input; if it cannot be opened, the script remains, and the page shows why.
  void useDevice(const device::FoundDevice& found)
  {
    control_.choose(found);
    prepare(InputSource::device);
  }
  void useDevice(InsertionControl::DeviceFactory device);
  void usePlugin(const std::filesystem::path& library)
  {
    control_.choose(library);
    prepare(InputSource::device);
  }

  /// Opens a recording for replay in place of the insertion; emits replayOpened() or
  /// replayFailed().
  void openReplay(const std::filesystem::path& file);
  const ReplayControl& replay() const { return *replay_; }
  /// Sets an earlier insertion drawn behind the next ones; empty to remove it.
  void setReference(const std::optional<ReferenceInsertion>& reference);

  /// Sets the force expected by a plan, drawn behind insertions of its array into its cochlea.
  void setPlan(const std::optional<PlannedForce>& plan) { presenter_.setPlan(plan); }

  /// Key actions. Functions that are not always possible return whether they were.
  bool takeReplayKey(const QKeyEvent& event);
  void pressSpace();
  HeldArray& held() { return held_; }
  void turnWheel(double notches, bool isZoom);
  bool leavePanel();
  bool cancelBuilding();
  bool rest();
  void togglePanel();

  /// Removes a device's force at once: Esc, the Stop button, a locked screen. True if there was one.
  bool stopDevice();
  /// The window lost the keyboard focus, or has it again.
  void loseKeyboard();
  void regainKeyboard() { safety_.regainKeyboard(); }
  /// Another page is shown: pauses motion.
  void leaveSight();
  /// The window ends: the force is zero when this returns.
  void end() { safety_.end(); }
  /// Stops the insertion permanently and returns the timing statistics of its loop.
  haptics::LoopStatistics halt() { return control_.halt(); }

  /// Shows an error until the next reset.
  void showError(const QString& sentence) { presenter_.showError(sentence); }
  /// Updates the display of the input device.
  void showInput() { presenter_.showInput(); }

  /// This page is visible.
  bool isShown() const { return isVisibleTo(window()); }
  const InsertionControl& control() const { return control_; }
  std::optional<device::DeviceHealth> deviceHealth() { return control_.deviceHealth(); }
  const SetupHistory& setup() const { return setup_->history(); }
  /// The error in the banner; empty if there is none.
  QString error() const { return presenter_.error(); }
  InsertionViews& views() { return *views_; }
  OperationView& view();
  FrameLoop& frames() { return *frames_; }

Q_SIGNALS:
  /// Another insertion is being recorded: control().recording().
  void recordingChanged();
  /// Another scenario or setup is shown, or a replay of one.
  void subjectChanged();
  /// The state may have changed; emitted fifteen times a second while the insertion runs.
  void stateShown();
  void devicesAsked();
  /// The user wants to search all saved patients, or to enter a new one.
  void allPatientsAsked();
  void newPatientAsked();
  void replayOpened();
  void replayFailed(const QString& sentence);
  /// A message that needs no answer; empty if there is none.
  void noted(const QString& sentence);

private:
  void layOut();
  void connectParts();
  void connectSetup();
  void openPatient(const anatomy::Patient& patient);
  void chooseInput(InputSource input)
  {
    if (input != control_.hand()) prepare(input);
  }
  void prepare(InputSource input);
  void use(const session::Scenario& scenario, const std::optional<InsertionControl::Parts>& parts);
  bool maySetUpNow() const;
  void beginReplay();
  void closeReplay();
  void step(double elapsed_s);
  void stepSlowly();
  void showState();
  void showPrepared();

  InsertionControl control_;
  SafetyStop safety_;
  SetupControl* setup_;
  SidePanel* side_;
  InsertionViews* views_;
  BottomBar* bottom_;
  BuildingNote* building_;
  ReplayControl* replay_;
  QStackedWidget* bars_;
  FrameLoop* frames_;
  InsertionPresenter presenter_;
  HeldArray held_;
  InputSource inputBefore_ = InputSource::scripted;  ///< Before the replay, or in the last window.
};

}  // namespace perilymph::gui
