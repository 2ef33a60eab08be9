// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/DrawingView.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "gui/widgets/DrawingPainter.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int dotsPerInch = 72;  // resolution of page points
// Text as that of the pages, whatever the size of the drawing.
constexpr double label_pt = figures::Label{}.size;
constexpr int smallestText_px = 10, text_px = 13;

}  // namespace

DrawingView::DrawingView(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("drawingView"));
  setMinimumSize(5 * dotsPerInch, 4 * dotsPerInch);
}

void DrawingView::show(figures::Drawing drawing)
{
  drawing_ = std::move(drawing);
  update();
}

void DrawingView::paintEvent(QPaintEvent*)
{
  if (drawing_.marks.empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double scale = std::min(width() / drawing_.width, height() / drawing_.height);
  painter.translate(0.5 * (width() - scale * drawing_.width),
                    0.5 * (height() - scale * drawing_.height));
  painter.scale(scale, scale);
  QPainterPath sheet;
  sheet.addRoundedRect(QRectF(0.0, 0.0, drawing_.width, drawing_.height), 4.0 / scale, 4.0 / scale);
  painter.fillPath(sheet, shownTheme().ground);
  const bool isDark = shownColorScheme() == ColorScheme::dark;
  const double wanted_px =
      std::clamp(label_pt * scale, double(sized(smallestText_px)), double(sized(text_px)));
  paintMarks(painter, drawing_, Lettering::scaled, isDark ? Sheet::dark : Sheet::white,
             wanted_px / (label_pt * scale));
}

}  // namespace perilymph::gui
