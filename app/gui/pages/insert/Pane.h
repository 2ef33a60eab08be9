#pragma once

// One part of the insertion page: a chart or a flat view under its title.

#include <QWidget>

class QBoxLayout;
class QLabel;

namespace perilymph::gui {

/// A title, a quiet note at its right or, where both have no room, under it, and below them what
/// they name. A double click asks for the
/// whole page.
class Pane : public QWidget {
  Q_OBJECT
public:
  /// @param content  Becomes the pane's; clicks on it should go through to the pane.
  Pane(const QString& title, const QString& note, QWidget* content, QWidget* parent);

  void setNote(const QString& note);
  /// Shown while the mouse rests on the title.
  void setTip(const QString& tip);

Q_SIGNALS:
  void maximizeAsked();

protected:
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void placeNote();

  QLabel* title_;
  QLabel* note_;
  QBoxLayout* head_;
};

}  // namespace perilymph::gui
