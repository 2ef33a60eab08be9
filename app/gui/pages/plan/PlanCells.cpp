// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanCells.h"

#include <QPainter>
#include <QPolygonF>
#include <QTextLayout>
#include <algorithm>

#include "gui/setup/PlannedFriction.h"
#include "gui/text/ClinicalText.h"
#include "gui/widgets/FocusRing.h"
#include "gui/widgets/Theme.h"
#include "perilymph/planning/ForceCourse.h"

namespace perilymph::gui {

namespace {

// At the window's usual text size: they shrink with the text, beside which they stand.
constexpr int margin_px = 6, bar_px = 8, quartileBar_px = 4, bandHeight_px = 10, shareHeight_px = 7;

QColor faded(QColor color, double opacity)
{
  color.setAlphaF(float(opacity));
  return color;
}

/// A line from left to right of a place, on which bands lie.
void paintTrack(QPainter& painter, const QRectF& place)
{
  painter.fillRect(QRectF(place.left(), place.center().y() - 0.5, place.width(), 1.0),
                   shownTheme().line);
}

/// A name in as many lines as fit; what does not fit ends in an ellipsis.
void paintName(QPainter& painter, const QRectF& place, const QString& name)
{
  const QFontMetricsF metrics(painter.font());
  const int lines = std::max(1, int(place.height() / metrics.lineSpacing()));
  QStringList shown;
  QTextLayout layout(name, painter.font());
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid() && shown.size() < lines;
       line = layout.createLine()) {
    line.setLineWidth(place.width());
    const int length = shown.size() + 1 < lines ? line.textLength() : -1;
    shown << metrics.elidedText(name.mid(line.textStart(), length).trimmed(), Qt::ElideRight,
                                place.width());
  }
  layout.endLayout();
  painter.drawText(place, int(Qt::AlignVCenter | Qt::AlignLeft), shown.join(QLatin1Char('\n')));
}

/// A value, and below it where it lies.
void paintTexts(QPainter& painter, const QRectF& place, const QString& value, const QString& range)
{
  painter.drawText(place, Qt::AlignTop | Qt::AlignLeft, value);
  painter.setFont(typeface(11));
  painter.setPen(shownTheme().quietText);
  const QString shown =
      QFontMetricsF(painter.font()).elidedText(range, Qt::ElideRight, place.width());
  painter.drawText(place.adjusted(0, sized(15), 0, 0), Qt::AlignTop | Qt::AlignLeft, shown);
}

/// What clinics report, below value and range.
void paintClinics(QPainter& painter, const QRectF& place, const planning::ArrayPlan& array,
                  PlanColumn column)
{
  painter.setFont(typeface(11));
  painter.setPen(shownTheme().text);
  const QString shown =
      QFontMetricsF(painter.font())
          .elidedText(PlanCells::clinicsText(array, column), Qt::ElideRight, place.width());
  painter.drawText(place.adjusted(0, sized(29), 0, 0), Qt::AlignTop | Qt::AlignLeft, shown);
}

void paintSpan(QPainter& painter, const QRectF& place, double from, double to, double height,
               const QColor& color)
{
  const double left = place.left() + std::clamp(from, 0.0, 1.0) * place.width();
  const double right = place.left() + std::clamp(to, 0.0, 1.0) * place.width();
  painter.fillRect(
      QRectF(left, place.center().y() - 0.5 * height, std::max(right - left, 1.0), height), color);
}

}  // namespace

PlanCells::PlanCells(const PlanTable& table, const QSortFilterProxyModel& sorted, QObject* parent)
    : QStyledItemDelegate(parent), table_(table), sorted_(sorted)
{
  if (const auto reference = coverageReference()) coverage_ = *reference;
}

QString PlanCells::clinicsText(const planning::ArrayPlan& array, PlanColumn column)
{
  const auto reported = reportedOf(column);
  const QString clinics = reported ? clinicsReportShort(array.array, *reported) : QString();
  if (clinics.isEmpty()) return {};
  const bool isShare = *reported == analysis::ReportedQuantity::translocation;
  return (isShare ? tr("transl. %1") : tr("clin. %1")).arg(clinics);
}

int PlanCells::clinicsWidth(const planning::ArrayPlan& array, PlanColumn column)
{
  const QString text = clinicsText(array, column);
  if (text.isEmpty()) return 0;
  return QFontMetrics(typeface(11)).horizontalAdvance(text) + 2 * margin_px + 2;
}

double PlanCells::limitOf(PlanColumn column) const
{
  const PlanTable::Axes& axes = table_.axes();
  switch (column) {
    case PlanColumn::angle:
      return axes.angle_deg;
    case PlanColumn::coverage:
      return 100.0;
    case PlanColumn::partition:
      return axes.partition_mN;
    default:
      return axes.force_mN;
  }
}

void PlanCells::paint(QPainter* painter, const QStyleOptionViewItem& option,
                      const QModelIndex& index) const
{
  const bool isSelected = (option.state & QStyle::State_Selected) != 0;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->fillRect(option.rect, isSelected ? shownTheme().raised : shownTheme().ground);
  painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1),
                    shownTheme().line);
  const auto column = static_cast<PlanColumn>(index.column());
  const planning::ArrayPlan& array = table_.array(sorted_.mapToSource(index).row());
  const QRectF inside = QRectF(option.rect).adjusted(margin_px, 4, -margin_px, -5);
  const PlanCellKind kind = kindOf(column);
  painter->setFont(kind == PlanCellKind::name ? typeface(12, QFont::Medium) : typeface(12));
  const QString mark = verdictMark(array.array);
  const bool isDoubtful = !mark.isEmpty();
  painter->setPen(isDoubtful ? shownTheme().quietText : shownTheme().text);
  if (kind == PlanCellKind::name) {
    const double mark_px = isDoubtful ? sized(15) : 0.0;
    paintName(*painter, inside.adjusted(0, 0, 0, -mark_px), index.data().toString());
    if (isDoubtful) {
      painter->setFont(typeface(11));
      painter->setPen(shownTheme().warning);
      painter->drawText(inside, Qt::AlignBottom | Qt::AlignLeft, mark);
    }
  } else if (kind == PlanCellKind::curve) {
    paintCurve(*painter, inside, array);
  } else if (kind == PlanCellKind::probability) {
    paintProbability(*painter, inside, estimateOf(array, column), array.draws);
    paintClinics(*painter, inside, array, column);
  } else {
    const planning::Band& band = bandOf(array, column);
    paintTexts(*painter, inside, medianText(band, column), rangeText(band, column));
    const QRectF below(inside.left(), inside.bottom() - sized(bandHeight_px), inside.width(),
                       sized(bandHeight_px));
    paintBand(*painter, below, band, column);
    paintClinics(*painter, inside, array, column);
  }
  painter->restore();
}

void PlanCells::paintBand(QPainter& painter, const QRectF& place, const planning::Band& band,
                          PlanColumn column) const
{
  const double limit = limitOf(column);
  paintTrack(painter, place);
  if (column == PlanColumn::coverage && coverage_) {
    const double left = place.left() + coverage_->low_percent / 100.0 * place.width();
    const double right = place.left() + coverage_->high_percent / 100.0 * place.width();
    painter.setPen(QPen(shownTheme().quietText, 1.0, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(left, place.top() - 1.0, right - left, place.height() + 2.0));
  }
  paintSpan(painter, place, band.low / limit, band.high / limit, sized(bar_px),
            faded(shownTheme().ghost, 0.4));
  paintSpan(painter, place, band.lowerQuartile / limit, band.upperQuartile / limit,
            sized(quartileBar_px), shownTheme().ghost);
  const double x = place.left() + std::clamp(band.median / limit, 0.0, 1.0) * place.width();
  painter.fillRect(QRectF(x - 1.0, place.top(), 2.0, place.height()), shownTheme().text);
}

void PlanCells::paintProbability(QPainter& painter, const QRectF& place,
                                 const analysis::Estimate& estimate, std::size_t draws) const
{
  paintTexts(painter, place, shownShare(estimate, draws), intervalText(estimate, draws));
  const QRectF bar(place.left(), place.bottom() - sized(shareHeight_px), place.width(),
                   sized(shareHeight_px));
  paintTrack(painter, bar);
  paintSpan(painter, bar, estimate.low, estimate.high, sized(quartileBar_px),
            faded(shownTheme().quietText, 0.7));
  const double x = bar.left() + std::clamp(estimate.value, 0.0, 1.0) * bar.width();
  painter.fillRect(QRectF(x - 1.0, bar.top(), 2.0, bar.height()), shownTheme().text);
}

void PlanCells::paintCurve(QPainter& painter, const QRectF& place,
                           const planning::ArrayPlan& array) const
{
  const PlanTable::Axes& axes = table_.axes();
  const std::vector<planning::ForceBand>& force = array.force;
  const auto at = [&](double depth_mm, double force_mN) {
    return QPointF(
        place.left() + depth_mm / axes.depth_mm * place.width(),
        place.bottom() - std::clamp(force_mN / axes.force_mN, 0.0, 1.0) * place.height());
  };
  painter.fillRect(QRectF(place.left(), place.bottom(), place.width(), 1.0), shownTheme().line);
  if (force.empty()) return;
  const std::size_t whole = planning::courseOf(array).whole;
  // of all simulations, and behind it of fewer: both share a row
  for (const auto& [first, end] : {std::pair{std::size_t{0}, whole}, {whole - 1, force.size()}}) {
    QPolygonF area, median;
    for (std::size_t i = first; i < end; ++i) {
      area << at(force[i].depth_mm, force[i].force_mN.high);
      median << at(force[i].depth_mm, force[i].force_mN.median);
    }
    for (std::size_t i = end; i-- > first;) area << at(force[i].depth_mm, force[i].force_mN.low);
    const bool isWhole = end == whole;
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(shownTheme().ghost, isWhole ? 0.4 : 0.2));
    painter.drawPolygon(area);
    painter.setPen(QPen(shownTheme().text, 1.5, isWhole ? Qt::SolidLine : Qt::DotLine));
    painter.drawPolyline(median);
  }
}

}  // namespace perilymph::gui
