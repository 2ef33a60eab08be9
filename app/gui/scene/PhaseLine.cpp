// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/PhaseLine.h"

#include <QPainter>
#include <array>

#include "gui/parts/Theme.h"

namespace perilymph::gui {

namespace {

using analysis::Phase;

constexpr int height_px = 44;
constexpr int sideMargin_px = 36;  // half a name beyond the outer stations
constexpr double stationY_px = 14.0;

constexpr std::array stations{Phase::opening, Phase::outerWall, Phase::basalTurn, Phase::full};

QString nameOf(Phase phase)
{
  switch (phase) {
    case Phase::opening:
      return PhaseLine::tr("Opening");
    case Phase::outerWall:
      return PhaseLine::tr("Outer wall");
    case Phase::basalTurn:
      return PhaseLine::tr("Basal turn");
    case Phase::full:
      return PhaseLine::tr("Full depth");
    case Phase::outside:
      break;
  }
  return PhaseLine::tr("Outside");
}

}  // namespace

PhaseLine::PhaseLine(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("phaseLine"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void PhaseLine::setPhase(Phase phase)
{
  if (phase == phase_) return;
  phase_ = phase;
  setAccessibleName(nameOf(phase));
  update();
}

QSize PhaseLine::sizeHint() const { return {480, height_px}; }

void PhaseLine::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  paintPlate(painter, rect());

  const double step = double(width() - 2 * sideMargin_px) / double(stations.size() - 1);
  const QColor ahead = aheadColor;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const QPointF place(sideMargin_px + double(i) * step, stationY_px);
    const bool isReached = phase_ >= stations[i];
    const bool isHere = phase_ == stations[i];
    if (i + 1 < stations.size()) {
      const bool isPassed = phase_ >= stations[i + 1];
      painter.setPen(QPen(isPassed ? accentColor : ahead, 2.0));
      painter.drawLine(place + QPointF(8, 0), place + QPointF(step - 8, 0));
    }
    painter.setPen(QPen(isReached ? accentColor : ahead, 2.0));
    painter.setBrush(isReached ? QBrush(accentColor) : QBrush(Qt::NoBrush));
    const double radius = isHere ? 6.5 : 4.5;
    painter.drawEllipse(place, radius, radius);

    painter.setFont(typeface(12, isHere ? QFont::DemiBold : QFont::Normal));
    painter.setPen(isHere ? textColor : quietTextColor);
    const QRectF name(place.x() - sideMargin_px, stationY_px + 10, 2 * sideMargin_px, 20);
    painter.drawText(name, Qt::AlignCenter | Qt::TextDontClip, nameOf(stations[i]));
  }
}

}  // namespace perilymph::gui
