#pragma once

// The workstation's window: its zones, its keys, and the one timer that keeps the picture new.

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "gui/parts/FrameMeter.h"
#include "gui/run/Background.h"
#include "gui/run/InsertionControl.h"
#include "gui/run/ModelBuilder.h"
#include "gui/run/SafetyStop.h"
#include "gui/setup/Setup.h"
#include "gui/shell/KeyActions.h"
#include "gui/shell/TopBar.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

class QStackedWidget;

namespace perilymph::gui {

class BottomBar;
class BuildingNote;
class ComparePage;
class DevicePage;
class ForceCharts;
class GuideSheet;
class InsertionViews;
class KeyList;
class Notice;
class OperationView;
class ReplayPlayer;
class ReplayBar;
class SessionsPage;
class SettingsSheet;
class SetupHistory;
class SidePanel;
class StartPage;
class ValidatePage;

/// Shows an insertion and asks for its next steps; computes none of it. A view pulls, converts,
/// draws: one turn of a timer, at most 60 times a second, updates everything and renders what
/// changed.
class MainWindow : public QWidget {
  Q_OBJECT
public:
  MainWindow(session::Scenario scenario, std::optional<std::filesystem::path> record);
  ~MainWindow() override;

  /// Builds the cochlea and prepares the insertion; then frames begin to run.
  Result<Done> open();

  /// Begins anew with another scenario, its array at its start and its cochlea built meanwhile.
  enum class AfterLoading { rest, insert };
  void load(session::Scenario scenario, AfterLoading then);
  /// The same where it is known what the patient's numbers come from.
  void load(const Setup& setup, SetupOrigin::Kind kind, AfterLoading then);

  /// Goes on with the setup of a window before this one, whose scenario is this one's.
  void resume(const SetupOrigin& origin, const Setup& now);

  /// The device of a plug-in, a shared library, becomes the hand; where it cannot, the script
  /// stays, and the window says why.
  void usePlugin(const std::filesystem::path& library);

  void start();
  void pause();
  void withdraw();
  /// A fresh insertion with the array at its start, moved by the same hand.
  void reset();

  /// Shows another page. An insertion that moves is paused: nobody would see where it goes.
  void showPage(Page page);
  Page page() const { return page_; }

  /// Says something over the foot of the window.
  Notice& notice() { return *notice_; }

  /// Writes a report of a recording as PDF, beside this thread; the page Sessions says how it went.
  void saveReport(const std::filesystem::path& file, const std::filesystem::path& pdf);

  /// Says in place what went wrong; stays until the next reset.
  void showError(const QString& sentence);

  const InsertionControl& control() const { return control_; }
  const SetupHistory& setup() const { return *setup_; }
  OperationView& view() { return *view_; }
  InsertionViews& views() { return *views_; }
  const FrameMeter& meter() const { return meter_; }
  /// Stops the insertion for good and says how its loop kept time.
  haptics::LoopStatistics halt() { return control_.halt(); }
  /// The window is about to end: the force is off when this returns.
  void end() { safety_.end(); }
  /// Frames are timed anew from now on.
  void restartMeter() { meter_ = {}; }

Q_SIGNALS:
  /// The first frame with the cochlea in it is on the display.
  void firstFrameShown();
  /// Another insertion is being recorded: control().recording().
  void recordingChanged();
  /// A window made anew would show what was chosen in the settings.
  void anewAsked();

protected:
  bool event(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void layOut();
  QWidget* insertPage();
  void connectZones();
  void connectSessions();
  void showSessions();
  void useGhost(const std::filesystem::path& file);
  void askForReport(const std::filesystem::path& file);
  void connectReplay();
  void openReplay(const std::filesystem::path& file);
  void beginReplay();
  void closeReplay();
  bool frameOfReplay(double elapsed_s);
  void showReplay();
  bool keyOfReplay(QKeyEvent* event);
  void onFrame();
  void onPresented();
  void showSlowly();
  void showState();
  void chooseHand(InputSource hand);
  void prepare(InputSource hand);
  void connectSetup();
  void useSetup();
  void build(const session::Scenario& scenario,
             std::function<void(const InsertionControl::Parts&)> use);
  void cancelBuilding();
  void use(const session::Scenario& scenario, const std::optional<InsertionControl::Parts>& parts);
  bool isChangeable() const;
  void undo();
  void redo();
  void showScenario();
  void showCochlea();
  void showPrepared();
  void begin(const anatomy::Patient& patient);
  void beginShipped(const std::string& name, AfterLoading then);
  void hold(bool isHeld);
  /// What a key does on the insertion page alone, or on every page.
  std::function<bool(int)> onInsertion(std::function<void(int)> act);
  std::function<bool(int)> onAnyPage(std::function<void(int)> act);
  void addKeys();
  void addInsertionKeys();
  void addPictureKeys();
  void addReplayKeys();
  void addWindowKeys();
  void pressSpace();
  void leave();
  bool leavePanel();
  void takePicture();
  void toggleSettings();
  void toggleKeyList();
  void toggleGuide();
  void toggleDevices();
  void useDevice(const device::FoundDevice& found);
  void showDevice();
  QString statusText() const;
  QString errorText() const;
  QString hintText() const;
  QString deviceHint() const;
  bool isNewToTheEye(const haptics::Snapshot& now);

  InsertionControl control_;
  SafetyStop safety_;
  SetupHistory* setup_;
  TopBar* top_;
  SidePanel* side_;
  InsertionViews* views_;
  OperationView* view_;
  ForceCharts* charts_;
  BottomBar* bottom_;
  KeyActions keyActions_;
  KeyList* keys_ = nullptr;
  GuideSheet* guide_;
  SettingsSheet* settings_;
  Notice* notice_;
  DevicePage* devices_;
  StartPage* startPage_;
  ValidatePage* validation_;
  ComparePage* comparison_;
  SessionsPage* sessions_;
  ReplayBar* replayBar_;
  ReplayPlayer* replay_;
  InputSource handBefore_ = InputSource::scripted;  ///< Input of the insertion before the replay.
  std::size_t charted_ = 0;  ///< Samples of the replay that are in the charts.
  QStackedWidget* bars_;
  Background reading_;
  ModelBuilder modelBuilder_;
  BuildingNote* building_;
  QStackedWidget* pages_;
  Page page_ = Page::insert;

  QTimer timer_;
  QElapsedTimer sinceFrame_, sinceSlow_;
  FrameMeter meter_;
  bool isFirstFrame_ = true;
  bool isStartAsked_ = false;  ///< Begin once the model is built.
  std::set<int> pressed_;      ///< Up and Down while they are held.
  QString error_;
  QString deviceText_;         ///< How the hand's device is doing; empty without one.
  haptics::Snapshot drawn_{};  ///< The picture the scene shows.
};

}  // namespace perilymph::gui
