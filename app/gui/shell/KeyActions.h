// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Key actions: one table that handles keys and generates the list of keys.

#include <QKeySequence>
#include <QString>
#include <QVector>
#include <functional>
#include <vector>

class QKeyEvent;

namespace perilymph::gui {

/// A key with modifiers.
inline QKeySequence with(Qt::KeyboardModifiers held, Qt::Key key)
{
  return QKeySequence(int(held) | int(key));
}

/// Sections of the list of keys.
enum class KeySection { insertion, picture, ct, replay, window };

/// An action triggered by keys.
struct KeyAction {
  KeySection section;
  QVector<QKeySequence> keys;  ///< Single keys with modifiers, no sequences.
  QString meaning;             ///< Description in the list of keys.
  /// @param which  Index of the pressed key in `keys`.
  /// @return Whether it was handled; if not, the key is passed on.
  std::function<bool(int which)> act;
  bool repeats = false;  ///< Also by auto-repeat.
};

/// A mouse gesture, or a key handled elsewhere: only for the list of keys.
struct Gesture {
  KeySection section;
  QString what, meaning;
};

class KeyActions {
public:
  void add(KeyAction action) { actions_.push_back(std::move(action)); }
  void add(Gesture gesture) { gestures_.push_back(std::move(gesture)); }

  /// Handles a key. False if no action applies now.
  bool take(const QKeyEvent& event) const;

  const std::vector<KeyAction>& actions() const { return actions_; }
  const std::vector<Gesture>& gestures() const { return gestures_; }

private:
  std::vector<KeyAction> actions_;
  std::vector<Gesture> gestures_;
};

/// An action's keys as text: "Ctrl+R", "A  D  W  X".
QString keysText(const KeyAction& action);

}  // namespace perilymph::gui
