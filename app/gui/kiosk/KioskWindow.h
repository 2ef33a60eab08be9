// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The booth: runs a demonstration until a visitor touches the screen, lets the visitor insert, and
// returns to the demonstration afterwards.

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <filesystem>
#include <optional>
#include <vector>

#include "gui/kiosk/ForceLevel.h"
#include "gui/kiosk/KioskClock.h"
#include "gui/kiosk/KioskScreen.h"
#include "gui/kiosk/Leaderboard.h"
#include "gui/kiosk/TakeAway.h"
#include "gui/kiosk/VisitorSession.h"
#include "gui/run/InsertionControl.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// A full-screen window without menus, files or settings. Only Ctrl+Alt+Q ends it. It makes no
/// recordings, because a booth runs for days.
class KioskWindow : public QWidget {
  Q_OBJECT
public:
  static constexpr double patience_s = 60.0;  ///< Time without input after which the demonstration
                                              ///< restarts.

  KioskWindow(session::Scenario scenario, std::filesystem::path board, KioskClock clock = {},
              std::shared_ptr<CochleaStore> cochleae = std::make_shared<CochleaStore>());
  ~KioskWindow() override;

  /// Builds the cochlea and starts the demonstration.
  Result<void> open();

  /// Begins a visitor's turn with a device.
  void useDevice(InsertionControl::DeviceFactory device);
  /// The screen was locked: removes the force of the visitor's device.
  void stopDevice();

  KioskStage stage() const { return stage_; }
  const InsertionControl& control() const { return control_; }
  const VisitorSession& turn() const { return turn_; }
  /// Text of the QR code beside the result; empty without one.
  QString takeAway() const;
  /// Number of timer events so far.
  std::uint64_t frames() const { return frames_; }

Q_SIGNALS:
  /// The first frame with the cochlea is on the display.
  void firstFrameShown();
  /// The keys that end the booth were pressed.
  void ended();
  /// A visitor chose the other language, or left and the operator's is to return: "de", or a locale's
  /// name. Nothing else ends or changes by it.
  void languageRequested(const QString& word);

protected:
  bool eventFilter(QObject* target, QEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

private:
  /// What the title says.
  enum class Message { attract, invite, stopped, unavailable, unstable, stuck, reached };
  /// A completed insertion.
  struct Reached {
    KioskEntry entry;
    TakeAway taken;
  };

  bool takeKey(QKeyEvent* event);
  void requestOtherLanguage();
  void retranslate();
  void use(std::size_t demonstration);
  void showScene();
  void beginAttract();
  void beginTurn(InputSource input);
  bool hasEndedEarly() const;
  void endTurn();
  void leaveResult();
  Reached reachedGoal();
  bool prepare(InputSource input);
  void chooseHandle();
  void setStage(KioskStage stage);
  void showDay();
  void showMessage(Message message);
  void showReached();
  void showDemonstration();

  void onFrame();
  void onPresented();
  void stepAttract();
  void stepTurn();
  void showPicture();
  void letGo();
  void continueTurn();
  bool isTouched() const;
  double now_s() const { return clock_.seconds(); }

  InsertionControl control_;
  KioskClock clock_;
  Leaderboard board_;
  std::optional<analysis::PrintedRange> peaks_;  ///< Range of the levels of force.
  VisitorSession turn_;
  KioskStage stage_ = KioskStage::attract;
  Message message_ = Message::attract;
  std::optional<Reached> reached_;  ///< In the stage `result`.
  QString language_;                ///< The operator's: name of the locale.
  bool isCounted_ = false;          ///< The visitor.

  std::vector<session::Scenario> tour_;  ///< The demonstration's; the visitors' is the first.
  std::vector<InsertionControl::Parts> parts_;  ///< For each of them.
  std::size_t shown_ = 0;                       ///< Index of the insertion in it.
  std::size_t drawn_ = 0;                       ///< Index of the array in the scene.

  KioskScreen* screen_;
  QTimer timer_;
  QElapsedTimer sinceFrame_, sinceSlow_;
  double touchedAt_s_ = 0.0;
  double stageAt_s_ = 0.0;             ///< Start of the current stage, or of this round of the
                                       ///< demonstration.
  std::optional<double> restingAt_s_;  ///< Demonstration: time of the end of the insertion.
  int station_ = -1;                   ///< Index of the camera view of the demonstration.
  int pushedByKey_ = 0;                ///< 1 in, -1 out, 0 none.
  std::pair<double, double> seen_{};   ///< Travel and force of the last drawn snapshot.
  std::uint64_t frames_ = 0;
  bool isFirstFrame_ = true;
};

}  // namespace perilymph::gui
