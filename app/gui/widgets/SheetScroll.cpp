// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/SheetScroll.h"

#include <QLayout>
#include <QScrollBar>
#include <algorithm>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

SheetScroll::SheetScroll(QWidget* content, QWidget* parent) : QScrollArea(parent)
{
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);  // it follows the focus of its fields
  setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
  setWidget(content);
}

QSize SheetScroll::sizeHint() const
{
  const QWidget& content = *widget();
  const QSize whole = content.sizeHint().expandedTo(content.minimumSizeHint());
  return {whole.width() + verticalScrollBar()->sizeHint().width(), whole.height()};
}

void fitSheet(QWidget& sheet)
{
  const QWidget& window = *sheet.parentWidget();
  const QSize maximum = window.size() - QSize(2 * spacing, 2 * spacing);
  // again and again: wrapped texts know their height when they have their width
  constexpr int passes = 4;
  for (int i = 0; i < passes; ++i) {
    sheet.layout()->invalidate();
    sheet.layout()->activate();
    sheet.adjustSize();
    sheet.resize(sheet.size().boundedTo(maximum));
    for (QLayout* each : sheet.findChildren<QLayout*>()) each->activate();
  }
  // Texts may go on changing lines and widths by turns: at this width all their lines count.
  const int whole = std::min(sheet.layout()->totalHeightForWidth(sheet.width()), maximum.height());
  if (sheet.height() < whole) sheet.resize(sheet.width(), whole);
  sheet.move(window.rect().center() - sheet.rect().center());
}

}  // namespace perilymph::gui
