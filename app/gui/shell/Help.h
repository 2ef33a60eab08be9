// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Help of the window: the list of keys (F1) and the user guide (Shift+F1).

#include <QObject>

class QWidget;

namespace perilymph::gui {

class GuideOverlay;
class KeyActions;
class KeyList;

/// Both are overlays of the window, shown on request.
class Help : public QObject {
  Q_OBJECT
public:
  explicit Help(QWidget* window);

  /// Makes the list of keys from the actions, when these are complete.
  void listKeys(const KeyActions& actions);

  void toggleKeys();
  void toggleGuide();
  bool areKeysShown() const;
  /// Hides the guide, or the list of keys. False if neither is shown.
  bool leaveGuide();
  bool leaveKeys();
  /// Adapts to the size of the window.
  void place();

private:
  QWidget* window_;
  GuideOverlay* guide_;
  KeyList* keys_ = nullptr;
};

}  // namespace perilymph::gui
