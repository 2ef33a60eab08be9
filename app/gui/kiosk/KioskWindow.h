#pragma once

// The workstation at a booth: it shows itself until somebody touches it, lets them insert, and
// goes back to showing itself when they have left.

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <filesystem>
#include <optional>

#include "gui/kiosk/KioskBoard.h"
#include "gui/kiosk/KioskClock.h"
#include "gui/kiosk/KioskScreen.h"
#include "gui/kiosk/KioskTurn.h"
#include "gui/run/InsertionControl.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// One full-screen window without menus, files or settings. Only Ctrl+Alt+Q ends it. It keeps no
/// recordings: a booth runs for days.
class KioskWindow : public QWidget {
  Q_OBJECT
public:
  static constexpr double patience_s = 60.0;  ///< Untouched for so long, it shows itself again.

  KioskWindow(session::Scenario scenario, std::filesystem::path board, KioskClock clock = {});
  ~KioskWindow() override;

  /// Builds the cochlea and begins to show itself.
  Result<Done> open();

  KioskStage stage() const { return stage_; }
  const InsertionControl& control() const { return control_; }
  const KioskTurn& turn() const { return turn_; }
  /// Turns of the timer so far.
  std::uint64_t frames() const { return frames_; }

Q_SIGNALS:
  /// The first frame with the cochlea in it is on the display.
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
  void beginTurn(InputSource hand);
  void endTurn();
  bool prepare(InputSource hand);
  void chooseHandle();
  void setStage(KioskStage stage);
  void showBoard(std::optional<int> chosen);

  void onFrame();
  void onPresented();
  void stepAttract();
  void stepTurn(double elapsed_s);
  void showPicture();
  void letGo();
  bool isTouched() const;
  double now_s() const { return clock_.seconds(); }

  InsertionControl control_;
  KioskClock clock_;
  KioskBoard board_;
  Result<analysis::Reference> inVivo_;
  KioskTurn turn_;
  KioskStage stage_ = KioskStage::attract;

  KioskScreen* screen_;
  QTimer timer_;
  QElapsedTimer sinceFrame_, sinceSlow_;
  double touchedAt_s_ = 0.0;
  double stageAt_s_ = 0.0;             ///< When this stage, or this round of attract, began.
  std::optional<double> restingAt_s_;  ///< Attract: since when the insertion is over.
  int station_ = -1;                   ///< Station of the attract tour.
  int pushedByKey_ = 0;                ///< 1 in, -1 out, 0 not at all.
  std::pair<double, double> drawn_{};  ///< Travel and force of the picture.
  std::uint64_t frames_ = 0;
  bool isFirstFrame_ = true;
};

}  // namespace perilymph::gui
