#pragma once

// What explains the window: the sheet of keys (F1) and the user guide (Shift+F1).

#include <QObject>

class QWidget;

namespace perilymph::gui {

class GuideSheet;
class KeyActions;
class KeyList;

/// Both sheets lie on the window and are shown when asked for.
class Help : public QObject {
  Q_OBJECT
public:
  explicit Help(QWidget* window);

  /// Makes the sheet of keys from the actions themselves, once these are complete.
  void listKeys(const KeyActions& actions);

  void toggleKeys();
  void toggleGuide();
  bool areKeysShown() const;
  /// Hides the guide, or the keys. False if it is not shown.
  bool leaveGuide();
  bool leaveKeys();
  /// The window has another size.
  void place();

private:
  QWidget* window_;
  GuideSheet* guide_;
  KeyList* keys_ = nullptr;
};

}  // namespace perilymph::gui
