// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/PaneArea.h"

#include <QPainter>
#include <algorithm>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int gap_px = 1;  // line between the parts
constexpr int topMargin_px = spacing;
constexpr int lowColumn_px = 430;  // below it, a third plot has no space for its axes
constexpr double columnFraction =
    0.34;  // of a wide area; a narrow one has shownLengths().chartColumn
constexpr double upperFraction = 0.6;     // of the height, in four parts
constexpr double sectionFraction = 0.54;  // of the lower right

/// Divides a rectangle into rows by fractions.
std::vector<QRect> rows(const QRect& whole, const std::vector<double>& fractions)
{
  double sum = 0.0;
  for (const double fraction : fractions) sum += fraction;
  std::vector<QRect> result;
  double done = 0.0;
  for (const double fraction : fractions) {
    const int top = whole.top() + int(done / sum * whole.height());
    done += fraction;
    const int bottom = whole.top() + int(done / sum * whole.height());
    result.emplace_back(whole.left(), top, whole.width(), bottom - top);
  }
  return result;
}

}  // namespace

PaneArea::PaneArea(QWidget* parent) : QWidget(parent) { setObjectName(QStringLiteral("paneArea")); }

void PaneArea::add(PaneRole role, QWidget* part)
{
  part->setParent(this);
  parts_.push_back({role, part});
  arrange();
}

void PaneArea::setArrangement(PaneLayout layout)
{
  maximized_.reset();
  const bool isNew = layout != layout_;
  layout_ = layout;
  arrange();
  if (isNew) Q_EMIT arrangementChanged(layout);
}

void PaneArea::nextArrangement()
{
  setArrangement(layout_ == PaneLayout::two    ? PaneLayout::four
                 : layout_ == PaneLayout::four ? PaneLayout::one
                                               : PaneLayout::two);
}

void PaneArea::toggleMaximized(PaneRole role)
{
  if (maximized_)
    maximized_.reset();
  else
    maximized_ = role;
  arrange();
}

std::vector<std::pair<PaneRole, QRect>> PaneArea::places() const
{
  if (maximized_) return {{*maximized_, rect()}};
  if (layout_ == PaneLayout::one) return {{PaneRole::picture, rect()}};

  const int leftWidth = std::max(1, width() - columnWidth() - gap_px);
  const QRect left(0, 0, leftWidth, height());
  const QRect right(leftWidth + gap_px, 0, columnWidth(), height());
  if (layout_ == PaneLayout::two && height() < sized(lowColumn_px)) {
    // two plots that can be read instead of three that cannot; four views show all
    const std::vector<QRect> column = rows(right.adjusted(0, topMargin_px, 0, 0), {0.58, 0.42});
    return {
        {PaneRole::picture, left}, {PaneRole::travel, column[0]}, {PaneRole::unrolled, column[1]}};
  }
  if (layout_ == PaneLayout::two) {
    const std::vector<QRect> column =
        rows(right.adjusted(0, topMargin_px, 0, 0), {0.46, 0.27, 0.27});
    return {{PaneRole::picture, left},
            {PaneRole::travel, column[0]},
            {PaneRole::unrolled, column[1]},
            {PaneRole::components, column[2]}};
  }

  const int upper = int(upperFraction * height());
  const QRect upperRight(right.left(), 0, right.width(), upper);
  const QRect lowerLeft(0, upper + gap_px, left.width(), height() - upper - gap_px);
  const QRect lowerRight(right.left(), upper + gap_px, right.width(), lowerLeft.height());
  const std::vector<QRect> column = rows(upperRight.adjusted(0, topMargin_px, 0, 0), {0.58, 0.42});
  const int sectionWidth = int(sectionFraction * lowerRight.width());
  return {
      {PaneRole::picture, QRect(0, 0, left.width(), upper)},
      {PaneRole::travel, column[0]},
      {PaneRole::components, column[1]},
      {PaneRole::unrolled, lowerLeft},
      {PaneRole::section, QRect(lowerRight.topLeft(), QSize(sectionWidth, lowerRight.height()))},
      {PaneRole::distances, lowerRight.adjusted(sectionWidth + gap_px, 0, 0, 0)}};
}

int PaneArea::columnWidth() const
{
  // In a narrow area the column is reduced in favor of the read-outs on the 3D view.
  int picture = 0;
  for (const Part& part : parts_)
    if (part.role == PaneRole::picture) picture = part.widget->minimumSizeHint().width();
  const int wished = std::max(shownLengths().chartColumn, int(columnFraction * width()));
  return std::clamp(width() - picture - gap_px, shownLengths().minChartColumn, wished);
}

void PaneArea::arrange()
{
  const auto seen = places();
  for (const Part& part : parts_) {
    const auto own = std::find_if(seen.begin(), seen.end(),
                                  [&](const auto& place) { return place.first == part.role; });
    if (own != seen.end()) part.widget->setGeometry(own->second);
    part.widget->setVisible(own != seen.end());
  }
  update();
}

void PaneArea::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  arrange();
}

void PaneArea::paintEvent(QPaintEvent*)
{
  // the lines between the parts are visible
  QPainter painter(this);
  painter.fillRect(rect(), shownTheme().panel);
  if (maximized_ || layout_ == PaneLayout::one) return;
  for (const auto& [role, widget] : parts_) {
    if (!widget->isVisible()) continue;
    const QRect place = widget->geometry();
    if (role == PaneRole::picture)
      painter.fillRect(QRect(place.right() + 1, 0, gap_px, height()), shownTheme().line);
    if (role == PaneRole::unrolled && layout_ == PaneLayout::four)
      painter.fillRect(QRect(0, place.top() - gap_px, width(), gap_px), shownTheme().line);
    if (role == PaneRole::section)
      painter.fillRect(QRect(place.right() + 1, place.top(), gap_px, place.height()),
                       shownTheme().line);
  }
}

}  // namespace perilymph::gui
