// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A text of several lines.

#include <QLabel>

namespace perilymph::gui {

/// A label that wraps its words and claims the height of all its lines at its width; QLabel claims
/// one line where its layout lies in another layout.
class WrappedLabel : public QLabel {
  Q_OBJECT
public:
  WrappedLabel(const QString& text, QWidget* parent);
  QSize minimumSizeHint() const override;

protected:
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace perilymph::gui
