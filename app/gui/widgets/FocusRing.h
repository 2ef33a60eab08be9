// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The mark of the widget with the keyboard focus: one ring for all kinds of widgets.

#include <QProxyStyle>
#include <QRect>

class QPainter;

namespace perilymph::gui {

/// Paints the focus ring inside an area: 2 px in the color of text, then 1.5 px in the color of
/// views. One of the two has a contrast of 3:1 or more on any fill; changes pen and brush.
void paintFocusRing(QPainter& painter, const QRect& area);

/// The Fusion style with this ring around a focused button, in place of a filled block in it.
class FocusRingStyle : public QProxyStyle {
  Q_OBJECT
public:
  FocusRingStyle();
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace perilymph::gui
