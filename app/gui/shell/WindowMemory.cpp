// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/WindowMemory.h"

#include "gui/shell/MainWindow.h"
#include "gui/shell/OverlayStack.h"
#include "gui/shell/SettingsOverlay.h"

namespace perilymph::gui {

WindowMemory memoryOf(MainWindow& window)
{
  const QWidget* focus = window.focusWidget();
  const bool isOwn = focus == nullptr || focus == &window;
  return {window.insertion().memory(), isOwn ? QString() : focus->objectName()};
}

void resume(MainWindow& window, const WindowMemory& memory)
{
  window.insertion().resume(memory.insertion);
  auto* focus = memory.focus.isEmpty() ? nullptr : window.findChild<QWidget*>(memory.focus);
  if (focus == nullptr) return;
  const auto* settings = window.findChild<SettingsOverlay*>();
  if (settings->isAncestorOf(focus)) window.sheets().toggleSettings();
  focus->setFocus();
}

}  // namespace perilymph::gui
