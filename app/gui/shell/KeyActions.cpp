// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/KeyActions.h"

#include <QKeyEvent>
#include <QStringList>

namespace perilymph::gui {

namespace {

/// The key with its modifiers. Keys that need Shift on some keyboards only ("?", "+") are treated
/// as the same key.
QKeySequence pressedKeys(const QKeyEvent& event)
{
  const int key = event.key();
  int modifiers = int(event.modifiers() & ~Qt::KeypadModifier);
  const bool isSymbol = key > Qt::Key_Space && key < Qt::Key_A;
  const bool isDigit = key >= Qt::Key_0 && key <= Qt::Key_9;
  if (isSymbol && !isDigit) modifiers &= ~int(Qt::ShiftModifier);
  return QKeySequence(key | modifiers);
}

}  // namespace

bool KeyActions::take(const QKeyEvent& event) const
{
  const QKeySequence pressed = pressedKeys(event);
  for (const KeyAction& action : actions_) {
    const int which = action.keys.indexOf(pressed);
    if (which < 0) continue;
    if (event.isAutoRepeat() && !action.repeats) return true;
    if (action.act(which)) return true;
  }
  return false;
}

QString keysText(const KeyAction& action)
{
  QStringList text;
  for (const QKeySequence& key : action.keys) text << key.toString(QKeySequence::NativeText);
  return text.join(QStringLiteral("  "));
}

}  // namespace perilymph::gui
