// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The screen of the booth: title, 3D view, display beside it, and the controls at the bottom.

#include <QWidget>

#include "perilymph/foundation/Units.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class DayView;
class LevelGauge;
class OperationView;
class QrView;
class SpeedPad;

/// Stage of the booth.
enum class KioskStage {
  attract,  ///< Demonstration: repeated insertion until a touch.
  turn,     ///< A visitor inserts.
  result    ///< The visitor has reached the goal, or the insertion failed.
};

/// The only screen of the booth. It displays and reports input; it is independent of insertions. All
/// lengths follow from the size of its type.
class KioskScreen : public QWidget {
  Q_OBJECT
public:
  explicit KioskScreen(QWidget* window);

  OperationView& view() { return *view_; }
  DayView& day() { return *day_; }
  LevelGauge& gauge() { return *gauge_; }

  /// Size of the type, whose capitals visitors see under minLetter_arcmin if the window has room for
  /// it [px, before textScale()].
  int letterSize() const { return letter_px_; }

  void showMessage(const QString& title, const QString& sentence);
  /// Shows the controls and the display of a stage.
  void showStage(KioskStage stage);
  /// Shows a text as a QR code beside the result; none if it is empty.
  void showCode(const QString& text);
  /// Small print at the bottom: where the levels of force are from.
  void setSource(const QString& source);
  /// Whether a haptic device can be used instead of the screen.
  void offerHandle(bool isThere);
  /// The visitor inserts with the haptic device, and can stop it, or with the screen.
  void useHandle(bool isHandle);

  /// An event for this object presses the Stop button.
  bool isStop(const QObject* target) const;
  /// The same for the button of the other language.
  bool isLanguage(const QObject* target) const;
  /// The plate or the button beside it is pressed.
  bool isPressed() const;
  /// Requested speed of the array, positive into the cochlea; zero while nothing is pressed.
  Speed speed() const;
  void release();

  /// Sets all fixed texts in the present language.
  void retranslate();

Q_SIGNALS:
  void startOverRequested();
  void handleRequested();
  void leaveRequested();
  void otherLanguageRequested();
  /// Remove the force of the device at once.
  void stopRequested();
  void letterSizeChanged();

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  QWidget* addInvitation();
  QWidget* addTurnFoot();
  QWidget* addResultFoot();
  QWidget* addHead();
  QWidget* addCode();
  QPushButton* addButton(const char* name, QWidget* parent);
  void fit();
  int lengthOf(double letters) const;

  int letter_px_ = 0;
  KioskStage stage_ = KioskStage::attract;
  bool isHandle_ = false;
  QLabel* title_;
  QLabel* sentence_;
  QPushButton* language_ = nullptr;
  OperationView* view_;
  DayView* day_;
  LevelGauge* gauge_;
  QWidget* code_ = nullptr;
  QrView* qr_ = nullptr;
  QLabel* scan_ = nullptr;
  QStackedWidget* foot_;
  QPushButton* invite_ = nullptr;
  SpeedPad* pad_ = nullptr;
  QPushButton *pull_ = nullptr, *handle_ = nullptr, *stop_ = nullptr, *startOver_ = nullptr;
  QPushButton *done_ = nullptr, *again_ = nullptr;
  QLabel* smallPrint_;
  QString source_;
};

}  // namespace perilymph::gui
