#pragma once

// The sheet of keys, shown over the page when asked for.

#include <QFrame>

namespace perilymph::gui {

class KeyActions;

/// A quiet sheet that names what keys and mouse do, made from the actions themselves.
class KeyList : public QFrame {
  Q_OBJECT
public:
  KeyList(const KeyActions& actions, QWidget* parent);

Q_SIGNALS:
  void guideAsked();
};

}  // namespace perilymph::gui
