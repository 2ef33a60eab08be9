// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/StudyPlot.h"

#include <vtkRenderWindow.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gui/pages/studies/StudyText.h"
#include "gui/scene/PlainVtkWidget.h"
#include "gui/text/ChartLabels.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr double reach_px = 12.0;  // of the mouse to a point
constexpr int trendSteps = 32;     // of a band, whose limits are curved

const std::vector<double>& columnOf(const study::StudyColumns& columns, const std::string& key)
{
  const study::StudyQuantity* found = columns.quantity(key);
  return found != nullptr ? found->values : columns.quantities().front().values;
}

std::pair<double, double> limitsOf(const std::vector<double>& values)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return low <= high ? std::pair{low, high} : std::pair{0.0, 1.0};
}

/// The line of the selected insertions of a group, between the first and the last of them.
std::vector<charts::TrendPoint> trendOf(const study::StudyColumns& columns,
                                        const study::StudyGroup& group,
                                        study::StudySelection selection,
                                        const std::vector<double>& x, const std::vector<double>& y)
{
  std::vector<double> places;
  for (const std::uint32_t row : group.rows)
    if (study::isIn(selection, columns.result(row)) && std::isfinite(x[row]) &&
        std::isfinite(y[row]))
      places.push_back(x[row]);
  const auto [low, high] = limitsOf(places);
  std::vector<charts::TrendPoint> points;
  for (int i = 0; i <= trendSteps; ++i) {
    const double place = low + (high - low) * i / trendSteps;
    const analysis::Estimate there = group.samples[selection].trend->at(place);
    points.push_back({place, there.value, there.low, there.high});
  }
  return points;
}

}  // namespace

StudyPlot::StudyPlot(QWidget* parent)
    : QFrame(parent), chart_(chartStyle(shownColorScheme())), view_(new PlainVtkWidget(this))
{
  setObjectName(QStringLiteral("studyPlot"));
  setAccessibleName(tr("Insertions of the study"));
  setFocusPolicy(Qt::StrongFocus);
  setProperty("focused", false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2, 2, 2, 2);
  column->addWidget(view_);
  chart_.setScale(devicePixelRatioF() * textScale());
  chart_.setCrossedLabel(tr("stopped before full depth").toStdString());
  chart_.attachTo(*view_->renderWindow());
  view_->installEventFilter(this);
}

StudyPlot::~StudyPlot() = default;

void StudyPlot::show(const StudyWork::Columns& columns, const Axes& axes)
{
  if (columns != columns_) rows_.clear();  // they are of the study before
  columns_ = columns;
  axes_ = axes;
  const auto [lowX, highX] = limitsOf(columnOf(*columns, axes.x));
  const auto [lowY, highY] = limitsOf(columnOf(*columns, axes.y));
  chart_.setTitles(quantityTitle(axes.x).toStdString(), quantityTitle(axes.y).toStdString());
  chart_.setRanges(lowX, highX, lowY, highY);
  showRows(std::move(rows_));
}

void StudyPlot::showRows(std::vector<std::uint32_t> rows)
{
  rows_ = std::move(rows);
  if (columns_) showGroups(nullptr, study::StudySelection::ran);
}

void StudyPlot::showTrends(const study::StudySummary& summary, study::StudySelection selection)
{
  showGroups(&summary, selection);
}

void StudyPlot::showGroups(const study::StudySummary* summary, study::StudySelection selection)
{
  const study::StudyFactor* factor = columns_->factor(axes_.group);
  const bool isGrouped = factor != nullptr;
  std::vector<charts::ScatterGroup> groups(isGrouped ? factor->levels.size() : 1);
  for (std::size_t i = 0; isGrouped && i < groups.size(); ++i)
    groups[i].label = inTheList(valueText(factor->key, factor->levels[i])).toStdString();
  const std::vector<double>& x = columnOf(*columns_, axes_.x);
  const std::vector<double>& y = columnOf(*columns_, axes_.y);
  for (const std::uint32_t row : rows_) {
    charts::ScatterGroup& group = groups[isGrouped ? factor->level[row] : 0];
    group.x.push_back(static_cast<float>(x[row]));
    group.y.push_back(static_cast<float>(y[row]));
    group.ids.push_back(row);
    group.isCrossed.push_back(columns_->result(row).insertion.end !=
                              analysis::InsertionEnd::finished);
  }
  for (std::size_t i = 0; summary != nullptr && i < summary->groups.size(); ++i) {
    const study::StudyGroup& found = summary->groups[i];
    if (!found.samples[selection].trend) continue;
    const std::size_t index = isGrouped ? factor->level[found.rows.front()] : 0;
    groups[index].trend = trendOf(*columns_, found, selection, x, y);
  }
  chart_.setGroups(std::move(groups));
  later();
}

void StudyPlot::select(std::optional<std::uint32_t> row)
{
  selected_ = row;
  chart_.setSelected(row);
  later();
}

/// Several changes in one turn of the event loop are one drawing.
void StudyPlot::later()
{
  if (isWaiting_) return;
  isWaiting_ = true;
  QTimer::singleShot(0, this, &StudyPlot::render);
}

void StudyPlot::render()
{
  isWaiting_ = false;
  if (!view_->isVisible() || !view_->isValid()) return;
  chart_.update();
  view_->renderWindow()->Render();
}

std::optional<std::uint32_t> StudyPlot::rowAt(const QPointF& place) const
{
  const double ratio = view_->devicePixelRatioF();
  return chart_.pick(place.x() * ratio, (view_->height() - place.y()) * ratio, reach_px * ratio);
}

bool StudyPlot::eventFilter(QObject* watched, QEvent* event)
{
  switch (event->type()) {
    case QEvent::Show:
    case QEvent::Resize:
      later();
      break;
    case QEvent::MouseButtonPress: {
      setFocus();
      const auto row = rowAt(static_cast<QMouseEvent*>(event)->localPos());
      if (row) Q_EMIT chosen(*row);
      return true;
    }
    case QEvent::MouseButtonDblClick:
      if (const auto row = rowAt(static_cast<QMouseEvent*>(event)->localPos())) Q_EMIT opened(*row);
      return true;
    default:
      break;
  }
  return QFrame::eventFilter(watched, event);
}

/// To the next point along an axis.
void StudyPlot::step(bool isAlongX, int by)
{
  if (!columns_ || rows_.empty()) return;
  const std::vector<double>& values = columnOf(*columns_, isAlongX ? axes_.x : axes_.y);
  std::vector<std::uint32_t> ordered;
  for (const std::uint32_t row : rows_)
    if (std::isfinite(values[row])) ordered.push_back(row);
  if (ordered.empty()) return;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [&values](std::uint32_t a, std::uint32_t b) { return values[a] < values[b]; });
  const auto here =
      selected_ ? std::find(ordered.begin(), ordered.end(), *selected_) : ordered.end();
  const auto last = std::ptrdiff_t(ordered.size()) - 1;
  const std::ptrdiff_t now =
      here == ordered.end() ? (by > 0 ? -1 : last + 1) : here - ordered.begin();
  Q_EMIT chosen(ordered[std::size_t(std::clamp(now + by, std::ptrdiff_t(0), last))]);
}

void StudyPlot::keyPressEvent(QKeyEvent* event)
{
  const int whole = int(rows_.size());
  switch (event->key()) {
    case Qt::Key_Left:
      return step(true, -1);
    case Qt::Key_Right:
      return step(true, 1);
    case Qt::Key_Down:
      return step(false, -1);
    case Qt::Key_Up:
      return step(false, 1);
    case Qt::Key_Home:
      return step(false, -whole);
    case Qt::Key_End:
      return step(false, whole);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (selected_) Q_EMIT opened(*selected_);
      return;
    default:
      QFrame::keyPressEvent(event);
  }
}

void StudyPlot::showFocus(bool isFocused)
{
  setProperty("focused", isFocused);
  style()->unpolish(this);
  style()->polish(this);
}

void StudyPlot::focusInEvent(QFocusEvent* event)
{
  QFrame::focusInEvent(event);
  showFocus(true);
}

void StudyPlot::focusOutEvent(QFocusEvent* event)
{
  QFrame::focusOutEvent(event);
  showFocus(false);
}

}  // namespace perilymph::gui
