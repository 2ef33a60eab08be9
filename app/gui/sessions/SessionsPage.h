#pragma once

// The library of recorded insertions: found, looked at, replayed, compared, thrown away.

#include <QWidget>

namespace perilymph::gui {

/// The recordings in the folder of sessions.
class SessionsPage : public QWidget {
  Q_OBJECT
public:
  explicit SessionsPage(QWidget* parent);
};

}  // namespace perilymph::gui
