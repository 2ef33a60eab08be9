// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The screen of the booth: title, 3D view, list, and the controls at the bottom.

#include <QWidget>

#include "perilymph/foundation/Units.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class LeaderboardView;
class OperationView;
class SpeedPad;

/// Stage of the booth.
enum class KioskStage {
  attract,  ///< Demonstration: repeated insertion until a touch.
  turn,     ///< A visitor inserts.
  result    ///< The visitor is at full depth, or the insertion failed.
};

/// The only screen of the booth. It displays and reports input; it is independent of insertions.
class KioskScreen : public QWidget {
  Q_OBJECT
public:
  /// Captions and legend, to be read from 1.5 m [px, before textScale()].
  static constexpr int label_px = 20;

  explicit KioskScreen(QWidget* window);

  OperationView& view() { return *view_; }
  LeaderboardView& board() { return *board_; }

  void showMessage(const QString& title, const QString& sentence);
  void showFooter(KioskStage stage);
  /// Whether a haptic device can be used instead of the screen.
  void offerHandle(bool isThere);
  /// The visitor inserts with the haptic device, and can stop it, or with the screen.
  void useHandle(bool isHandle);

  /// An event for this object presses the Stop button.
  bool isStop(const QObject* target) const;
  /// The plate or the button beside it is pressed.
  bool isPressed() const;
  /// Requested speed of the array, positive into the cochlea; zero while nothing is pressed.
  Speed speed() const;
  void release();

Q_SIGNALS:
  void startOverRequested();
  void handleRequested();
  void leaveRequested();
  /// Remove the force of the device at once.
  void stopRequested();

private:
  QWidget* addInvitation();
  QWidget* addTurnFoot();
  QWidget* addResultFoot();
  QPushButton* addButton(const QString& text, const char* name, QWidget* parent);

  QLabel* title_;
  QLabel* sentence_;
  OperationView* view_;
  LeaderboardView* board_;
  QStackedWidget* foot_;
  SpeedPad* pad_ = nullptr;
  QPushButton* pull_ = nullptr;
  QPushButton* handle_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace perilymph::gui
