#pragma once

// What is seen at the booth: a title, the picture, the board, and at the foot what can be pressed.

#include <QWidget>

#include "perilymph/foundation/Units.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class BoardView;
class OperationView;
class PushPad;

/// What the booth is doing.
enum class KioskStage {
  attract,  ///< An insertion that repeats, until a touch.
  turn,     ///< A visitor inserts.
  result    ///< The visitor is at full depth, or the insertion could not go on.
};

/// The one screen of the booth. It shows and tells what is pressed; it knows no insertion.
class KioskScreen : public QWidget {
  Q_OBJECT
public:
  explicit KioskScreen(QWidget* window);

  OperationView& view() { return *view_; }
  BoardView& board() { return *board_; }

  void say(const QString& title, const QString& sentence);
  void showFoot(KioskStage stage);
  /// A handle can be chosen in place of the screen.
  void offerHandle(bool isThere);
  /// The visitor inserts with the handle, or with the screen.
  void useHandle(bool isHandle);

  /// The plate or the button beside it is pressed.
  bool isPressed() const;
  /// How fast the array is to move, positive into the cochlea; zero while nothing is pressed.
  Speed speed() const;
  void release();

Q_SIGNALS:
  void startOverAsked();
  void handleAsked();
  void leaveAsked();

private:
  QWidget* addInvitation();
  QWidget* addTurnFoot();
  QWidget* addResultFoot();
  QPushButton* addButton(const QString& text, const char* name, QWidget* parent);

  QLabel* title_;
  QLabel* sentence_;
  OperationView* view_;
  BoardView* board_;
  QStackedWidget* foot_;
  PushPad* pad_ = nullptr;
  QPushButton* pull_ = nullptr;
  QPushButton* handle_ = nullptr;
};

}  // namespace perilymph::gui
