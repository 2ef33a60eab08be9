// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A part of the insertion page: a chart or a flat view with a title.

#include <QWidget>

class QBoxLayout;
class QLabel;

namespace perilymph::gui {

/// A title, a note at its right or, if there is no space, below it, and the content. A double click
/// requests the whole page.
class Pane : public QWidget {
  Q_OBJECT
public:
  /// @param content  Becomes a child of the pane; clicks on it should reach the pane.
  Pane(const QString& title, const QString& note, QWidget* content, QWidget* parent);

  void setNote(const QString& note);
  /// Sets the tooltip of the title.
  void setTip(const QString& tip);

Q_SIGNALS:
  void maximizeRequested();

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
