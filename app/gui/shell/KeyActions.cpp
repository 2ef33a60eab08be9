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
    const int which = int(action.keys.indexOf(pressed));
    if (which < 0) continue;
    if (event.isAutoRepeat() && !action.repeats) return true;
    if (action.act(which)) return true;
  }
  return false;
}

// Names of keys as QKeySequence writes them, so that they are translated where Qt's own
// translations are not installed.
[[maybe_unused]] constexpr const char* keyNames[] = {
    QT_TRANSLATE_NOOP("QShortcut", "Ctrl"),   QT_TRANSLATE_NOOP("QShortcut", "Shift"),
    QT_TRANSLATE_NOOP("QShortcut", "Alt"),    QT_TRANSLATE_NOOP("QShortcut", "Space"),
    QT_TRANSLATE_NOOP("QShortcut", "Esc"),    QT_TRANSLATE_NOOP("QShortcut", "Backspace"),
    QT_TRANSLATE_NOOP("QShortcut", "Return"), QT_TRANSLATE_NOOP("QShortcut", "Enter"),
    QT_TRANSLATE_NOOP("QShortcut", "Home"),   QT_TRANSLATE_NOOP("QShortcut", "Left"),
    QT_TRANSLATE_NOOP("QShortcut", "Right"),  QT_TRANSLATE_NOOP("QShortcut", "Up"),
    QT_TRANSLATE_NOOP("QShortcut", "Down"),   QT_TRANSLATE_NOOP("QShortcut", "PgUp"),
    QT_TRANSLATE_NOOP("QShortcut", "PgDown"), QT_TRANSLATE_NOOP("QShortcut", "Del")};

QString keysText(const KeyAction& action)
{
  QStringList text;
  for (const QKeySequence& key : action.keys) text << key.toString(QKeySequence::NativeText);
  return text.join(QStringLiteral("  "));
}

}  // namespace perilymph::gui
