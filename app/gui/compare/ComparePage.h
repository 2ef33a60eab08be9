#pragma once

// Several recorded insertions over one axis: curves, a cursor through all of them, a table.

#include <QWidget>

namespace perilymph::gui {

/// Insertions side by side.
class ComparePage : public QWidget {
  Q_OBJECT
public:
  explicit ComparePage(QWidget* parent);
};

}  // namespace perilymph::gui
