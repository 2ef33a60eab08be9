// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/AngleRing.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr double turns = 2.5, innerRadius = 0.25, step_deg = 3.0, dot_px = 3.5,
                 ringMargin_px = 24.0;

}  // namespace

AngleRing::AngleRing(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("angleRing"));
  setAccessibleName(tr("Angles of the contacts from the round window"));
  setToolTip(
      tr("Contacts at their median angles from the round window, seen from the apex; arcs: "
         "the band that the head names. The radius is not to scale."));
}

void AngleRing::show(const std::vector<planning::ContactBand>& contacts, anatomy::Side side,
                     std::vector<FoundAngle> found)
{
  contacts_ = contacts;
  found_ = std::move(found);
  side_ = side;
  update();
}

void AngleRing::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), shownTheme().ground);
  const QPointF center(0.5 * width(), 0.5 * height());
  const double outer = 0.5 * std::min(width(), height()) - ringMargin_px * textScale();
  const double hand = side_ == anatomy::Side::left ? -1.0 : 1.0;
  // as the pictures seen from the apex: 0 degrees at the left of a right ear, further ones
  // counterclockwise; a left ear is its mirror image
  const auto at = [&](double angle_deg, double radius) {
    const double angle = degrees(angle_deg).si();
    return center + QPointF(-hand * std::cos(angle), std::sin(angle)) * radius;
  };
  const auto radiusAt = [&](double angle_deg) {
    return outer * (1.0 - (1.0 - innerRadius) * std::clamp(angle_deg / (360.0 * turns), 0.0, 1.0));
  };
  const auto arc = [&](double from_deg, double to_deg) {
    QPolygonF line;
    for (double angle = from_deg; angle < to_deg; angle += step_deg)
      line << at(angle, radiusAt(angle));
    return line << at(to_deg, radiusAt(to_deg));
  };
  painter.setFont(typeface(11));
  const QFontMetricsF metrics(painter.font());
  for (const int angle : {0, 90, 180, 270}) {
    painter.setPen(QPen(shownTheme().line, 1.0));
    painter.drawLine(at(angle, 0.15 * outer), at(angle, outer));
    painter.setPen(shownTheme().quietText);
    const QString text = tr("%1°").arg(angle);
    const QPointF place = at(angle, outer + 0.6 * ringMargin_px * textScale());
    const QRectF around(place.x() - 30.0, place.y() - 10.0, 60.0, 20.0);
    painter.drawText(around, Qt::AlignCenter, text);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(shownTheme().border, 1.0));
  painter.drawPolyline(arc(0.0, 360.0 * turns));
  QColor band = shownTheme().ghost;
  band.setAlphaF(0.4f);
  for (const planning::ContactBand& each : contacts_) {
    if (each.draws == 0) continue;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(band, 5.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawPolyline(arc(std::max(each.angle_deg.low, 0.0), each.angle_deg.high));
  }
  for (const planning::ContactBand& each : contacts_) {
    if (each.draws == 0) continue;
    painter.setPen(QPen(shownTheme().ground, 1.0));
    painter.setBrush(found_.empty() ? shownTheme().text : shownTheme().ghost);
    painter.drawEllipse(at(each.angle_deg.median, radiusAt(each.angle_deg.median)), dot_px, dot_px);
  }
  for (const FoundAngle& each : found_) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(shownTheme().text, 1.5, Qt::SolidLine, Qt::FlatCap));
    painter.drawPolyline(arc(std::max(each.low_deg, 0.0), each.high_deg));
    painter.setPen(QPen(shownTheme().text, 1.0));
    painter.setBrush(shownTheme().accent);
    painter.drawEllipse(at(each.angle_deg, radiusAt(each.angle_deg)), dot_px, dot_px);
  }
  std::optional<double> apical_deg;
  if (!found_.empty())
    apical_deg = found_.front().angle_deg;
  else if (!contacts_.empty() && contacts_.front().draws > 0)
    apical_deg = contacts_.front().angle_deg.median;
  if (!apical_deg) return;
  painter.setPen(shownTheme().text);
  painter.setFont(typeface(13, QFont::DemiBold));
  painter.drawText(rect(), Qt::AlignCenter, tr("%1°").arg(numberText(*apical_deg, 0)));
}

}  // namespace perilymph::gui
