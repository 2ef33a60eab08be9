#pragma once

// What keys do: one table that acts on them and from which the sheet of keys is made.

#include <QKeySequence>
#include <QString>
#include <QVector>
#include <functional>
#include <vector>

class QKeyEvent;

namespace perilymph::gui {

/// A key that is pressed while others are held.
inline QKeySequence with(Qt::KeyboardModifiers held, Qt::Key key)
{
  return QKeySequence(int(held) | int(key));
}

/// What the sheet puts under one heading.
enum class KeySection { insertion, picture, replay, window };

/// Something keys ask for.
struct KeyAction {
  KeySection section;
  QVector<QKeySequence> keys;  ///< Single keys with their modifiers, none of two strokes.
  QString meaning;             ///< As the sheet says it.
  /// @param which  Place of the pressed key in `keys`.
  /// @return Whether it was done; if not, the key goes on to whoever else wants it.
  std::function<bool(int which)> act;
  bool repeats = false;  ///< Also while the key is held down.
};

/// What the mouse does, or a key that is not asked of the table: on the sheet only.
struct Gesture {
  KeySection section;
  QString what, meaning;
};

class KeyActions {
public:
  void add(KeyAction action) { actions_.push_back(std::move(action)); }
  void add(Gesture gesture) { gestures_.push_back(std::move(gesture)); }

  /// Does what a key asks for. False if no action wants it now.
  bool take(const QKeyEvent& event) const;

  const std::vector<KeyAction>& actions() const { return actions_; }
  const std::vector<Gesture>& gestures() const { return gestures_; }

private:
  std::vector<KeyAction> actions_;
  std::vector<Gesture> gestures_;
};

/// An action's keys as people read them: "Ctrl+R", "A  D  W  X".
QString keysText(const KeyAction& action);

}  // namespace perilymph::gui
