// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The head of the panel: scenario, modification state, undo and redo.

#include <QWidget>

class QLabel;
class QPushButton;

namespace perilymph::gui {

class SetupHistory;

/// Shows the scenario. A modified preset is marked MODIFIED and can be restored.
class ScenarioHeader : public QWidget {
  Q_OBJECT
public:
  explicit ScenarioHeader(QWidget* parent);

  void show(const SetupHistory& history);
  /// Enables changes, or disables them with a reason.
  void setChangeable(bool isChangeable);

Q_SIGNALS:
  void undoRequested();
  void redoRequested();
  void restoreRequested();
  void collapseRequested();

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
