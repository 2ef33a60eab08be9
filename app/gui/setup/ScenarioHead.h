#pragma once

// The head of the panel: what the window is about, whether it still is that, undo and redo.

#include <QWidget>

class QLabel;
class QPushButton;

namespace perilymph::gui {

class SetupHistory;

/// Names the scenario. A preset with other values wears MODIFIED and offers the way back.
class ScenarioHead : public QWidget {
  Q_OBJECT
public:
  explicit ScenarioHead(QWidget* parent);

  void show(const SetupHistory& history);
  /// Changes are possible, or not now, for a reason in words.
  void setChangeable(bool isChangeable);

Q_SIGNALS:
  void undoAsked();
  void redoAsked();
  void restoreAsked();
  void collapseAsked();

private:
  QPushButton* addButton(const QString& text, const char* name);
  void enableButtons();

  QLabel* badge_;
  QLabel* title_;
  QLabel* locked_;
  QPushButton* restore_;
  QPushButton* undo_;
  QPushButton* redo_;
  bool isChangeable_ = true;
  bool canUndo_ = false, canRedo_ = false;
};

}  // namespace perilymph::gui
