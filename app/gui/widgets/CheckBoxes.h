// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Check boxes and radio buttons in the window's style: state is shown by a mark, not by color
// alone. Long texts are wrapped.

#include <QCheckBox>
#include <QRadioButton>

namespace perilymph::gui {

/// A check box: a filled square with a check mark when on, an outline when off.
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

/// A radio button: a filled dot in a ring when selected, an empty ring when not.
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
