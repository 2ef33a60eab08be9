// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/PlotView.h"

#include <QPainter>

#include "gui/widgets/DrawingPainter.h"

namespace perilymph::gui {

PlotView::PlotView(Draw draw, QWidget* parent) : QWidget(parent), draw_(std::move(draw))
{
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void PlotView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintMarks(painter, draw_(width(), height()), Lettering::onScreen);
}

}  // namespace perilymph::gui
