// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Undo and redo of setup changes.

#include <QObject>
#include <QUndoStack>
#include <vector>

#include "gui/setup/Setup.h"

namespace perilymph::gui {

/// Owns the current setup. Consecutive changes of one field count as one.
class SetupHistory : public QObject {
  Q_OBJECT
public:
  explicit SetupHistory(QObject* parent);

  /// Starts a new history without undo steps.
  void begin(Setup setup, SetupOrigin::Kind kind);

  /// One change, with the setups before and after it.
  struct Step {
    Setup before, after;
    SetupField field = SetupField::preset;
    int epoch = 0;
    QString text;
  };
  /// A history that another window continues.
  struct Memory {
    SetupOrigin origin;
    Setup now;
    std::vector<Step> steps;
    int index = 0;  ///< Index of the first step that can be redone.
  };
  Memory memory() const;
  void resume(const Memory& memory);

  const Setup& now() const { return now_; }
  const SetupOrigin& origin() const { return origin_; }
  /// It is based on a preset, but differs from it.
  bool isModified() const;
  /// The changes as text: "array, speed"; empty if there are none.
  QString changedText() const;

  /// Makes a change, or reports why it is impossible.
  void change(const SetupChange& change);
  /// Restores the origin, as a further change.
  void restore();
  /// Separates the next change, so that it is not merged with previous ones.
  void seal() { ++epoch_; }

  void undo();
  void redo();
  /// Moves in the history to the state with this scenario; to the origin if there is none.
  void goTo(const std::string& scenarioText);
  const QUndoStack& stack() const { return stack_; }

Q_SIGNALS:
  /// The setup changed: by a change, undo or redo.
  void setupChanged();
  /// A change failed; the setup is unchanged.
  void refused(const QString& sentence);

private:
  friend class SetupCommand;
  void push(Setup after, SetupField field, const QString& label);

  QUndoStack stack_;
  SetupOrigin origin_;
  Setup now_;
  int epoch_ = 0;
};

}  // namespace perilymph::gui
