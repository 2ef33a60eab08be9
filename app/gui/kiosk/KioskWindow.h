// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The booth: runs a demonstration until a visitor touches the screen, lets the visitor insert, and
// returns to the demonstration afterwards.

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <filesystem>
#include <optional>

#include "gui/kiosk/KioskClock.h"
#include "gui/kiosk/KioskScreen.h"
#include "gui/kiosk/Leaderboard.h"
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
  /// Number of timer events so far.
  std::uint64_t frames() const { return frames_; }

Q_SIGNALS:
  /// The first frame with the cochlea is on the display.
  void firstFrameShown();
  /// The keys that end the booth were pressed.
  void ended();

protected:
  bool eventFilter(QObject* target, QEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

private:
  bool takeKey(QKeyEvent* event);
  void beginAttract();
  void beginTurn(InputSource input);
  bool hasEndedEarly() const;
  void endTurn();
  bool prepare(InputSource input);
  void chooseHandle();
  void setStage(KioskStage stage);
  void showBoard(std::optional<int> chosen);

  void onFrame();
  void onPresented();
  void stepAttract();
  void stepTurn(double elapsed_s);
  void showPicture();
  void letGo();
  void continueTurn();
  void inviteToTurn();
  bool isTouched() const;
  double now_s() const { return clock_.seconds(); }

  InsertionControl control_;
  KioskClock clock_;
  Leaderboard board_;
  Result<analysis::PrintedRange> peaks_;
  VisitorSession turn_;
  KioskStage stage_ = KioskStage::attract;

  KioskScreen* screen_;
  QTimer timer_;
  QElapsedTimer sinceFrame_, sinceSlow_;
  double touchedAt_s_ = 0.0;
  double stageAt_s_ = 0.0;             ///< Start of the current stage, or of this round of the
                                       ///< demonstration.
  std::optional<double> restingAt_s_;  ///< Demonstration: time of the end of the insertion.
  int station_ = -1;                   ///< Index of the camera view of the demonstration.
  int pushedByKey_ = 0;                ///< 1 in, -1 out, 0 none.
  std::pair<double, double> drawn_{};  ///< Travel and force of the last drawn snapshot.
  std::uint64_t frames_ = 0;
  bool isFirstFrame_ = true;
};

}  // namespace perilymph::gui
