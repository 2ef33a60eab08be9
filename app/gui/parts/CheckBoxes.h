#pragma once

// Check boxes and choices in the window's own drawing: a mark, not only a color, tells the state.
// Words without room for one line stand in several.

#include <QCheckBox>
#include <QRadioButton>

namespace perilymph::gui {

/// A check box: an accent square with a tick when on, an outline when off.
class CheckBox : public QCheckBox {
  Q_OBJECT
public:
  explicit CheckBox(const QString& text, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

protected:
  void paintEvent(QPaintEvent*) override;
  bool hitButton(const QPoint& place) const override { return rect().contains(place); }
};

/// One of several: a filled dot in a ring when chosen, an empty ring when not.
class Choice : public QRadioButton {
  Q_OBJECT
public:
  explicit Choice(const QString& text, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

protected:
  void paintEvent(QPaintEvent*) override;
  bool hitButton(const QPoint& place) const override { return rect().contains(place); }
};

}  // namespace perilymph::gui
