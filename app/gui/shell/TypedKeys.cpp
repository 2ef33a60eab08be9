// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/TypedKeys.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

#include "gui/run/UserSettings.h"
#include "gui/shell/SettingsOverlay.h"

namespace perilymph::gui {

bool isTyped(const QKeyEvent& event)
{
  const bool isCommand = (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != 0;
  return !isCommand && event.key() >= Qt::Key_Space && event.key() <= Qt::Key_ydiaeresis;
}

bool takesText(const QWidget* widget)
{
  return qobject_cast<const QLineEdit*>(widget) != nullptr ||
         qobject_cast<const QComboBox*>(widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
         qobject_cast<const QAbstractItemView*>(widget) != nullptr;
}

bool areLettersOff(const QKeyEvent& event)
{
  if (event.key() == Qt::Key_Space || event.isAutoRepeat()) return false;
  return UserSettings().word(QStringLiteral("keys"), letterKeysText()) == QLatin1String("off");
}

}  // namespace perilymph::gui
