#pragma once

// The list of keys, shown over the picture when asked for.

#include <QFrame>

namespace perilymph::gui {

/// A quiet sheet that names every key and what the mouse does.
class KeyList : public QFrame {
  Q_OBJECT
public:
  explicit KeyList(QWidget* parent);
};

}  // namespace perilymph::gui
