#pragma once

// The page of the insertion: panel, picture, charts, bars, and what a person does with them.

#include <QWidget>
#include <filesystem>
#include <optional>

#include "gui/pages/insert/HeldArray.h"
#include "gui/pages/insert/InsertionPresenter.h"
#include "gui/pages/insert/SetupControl.h"
#include "gui/run/InsertionControl.h"
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

/// Shows an insertion and asks for its next steps; computes none of it. In its place a recording
/// may be replayed: then no loop runs and no device is open.
class InsertPage : public QWidget {
  Q_OBJECT
public:
  InsertPage(session::Scenario scenario, std::optional<std::filesystem::path> record,
             QWidget* parent);
  ~InsertPage() override;

  /// Builds the cochlea and prepares the insertion; then frames begin to run.
  Result<Done> open();

  /// Another scenario, its array at its start and its cochlea built meanwhile. It is about to be
  /// shown.
  enum class AfterLoading { rest, insert };
  void load(const Setup& setup, SetupOrigin::Kind kind, AfterLoading then);
  /// Goes on with the setup of a window before this one, whose scenario is this one's.
  void resume(const SetupOrigin& origin, const Setup& now);

  void start();
  /// Lets go of the array: it stays where it is.
  void pause();
  void withdraw();
  /// A fresh insertion with the array at its start, moved by the same hand.
  void reset();
  void pullStylet() { control_.pullStylet(); }
  void undo();
  void redo();

  /// The device becomes the hand; where it cannot be opened, the script stays, and the page says
  /// why.
  void useDevice(const device::FoundDevice& found);
  void usePlugin(const std::filesystem::path& library);

  /// Opens a recording to be replayed in the place of the insertion: replayOpened() or
  /// replayFailed() follows.
  void openReplay(const std::filesystem::path& file);
  const ReplayControl& replay() const { return *replay_; }
  /// An earlier insertion behind the next ones.
  void setGhost(const std::vector<std::pair<Length, Force>>& curve, const QString& name);

  /// What keys ask for. Functions that are not always possible say whether something was done.
  bool takeReplayKey(const QKeyEvent& event);
  void pressSpace();
  HeldArray& held() { return held_; }
  void turnWheel(double notches, bool isZoom);
  bool leavePanel();
  bool cancelBuilding();
  bool rest();
  void togglePanel();

  /// The window lost the keyboard.
  void loseKeyboard();
  /// Another page is shown: what moves rests.
  void leaveSight();
  /// The window ends: the force is off when this returns.
  void end() { safety_.end(); }
  /// Stops the insertion for good and says how its loop kept time.
  haptics::LoopStatistics halt() { return control_.halt(); }

  /// Says in place what went wrong; stays until the next reset.
  void showError(const QString& sentence) { presenter_.showError(sentence); }
  /// Says again which hand is in use.
  void showInput() { presenter_.showInput(); }

  /// It is the page that is shown.
  bool isShown() const { return isVisibleTo(window()); }
  const InsertionControl& control() const { return control_; }
  std::optional<device::DeviceHealth> deviceHealth() { return control_.deviceHealth(); }
  const SetupHistory& setup() const { return setup_->history(); }
  /// What went wrong, as the banner says it; empty while all is well.
  QString error() const { return presenter_.error(); }
  InsertionViews& views() { return *views_; }
  OperationView& view();
  FrameLoop& frames() { return *frames_; }

Q_SIGNALS:
  /// Another insertion is being recorded: control().recording().
  void recordingChanged();
  /// Another scenario or another setup is shown, or a recording of one.
  void subjectChanged();
  /// How the insertion is doing may have changed; fifteen times a second while it runs.
  void stateShown();
  void devicesAsked();
  void replayOpened();
  void replayFailed(const QString& sentence);

private:
  void layOut();
  void connectParts();
  void connectSetup();
  void chooseInput(InputSource input);
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
  InputSource inputBefore_ = InputSource::scripted;  ///< The replay.
};

}  // namespace perilymph::gui
