// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A line of text that yields where there is not enough width.

#include <QLabel>

namespace perilymph::gui {

/// A label of one line that ends in an ellipsis where it does not fit; its tooltip is then the
/// whole text.
class ElidedLabel : public QLabel {
  Q_OBJECT
public:
  explicit ElidedLabel(QWidget* parent);
  QSize minimumSizeHint() const override;
  bool isWhole() const;

protected:
  void paintEvent(QPaintEvent*) override;
  bool event(QEvent* event) override;
};

}  // namespace perilymph::gui
