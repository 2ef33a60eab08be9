// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/PhaseLine.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

using analysis::Phase;

constexpr int name_px = 12;
constexpr int sideMargin_px = 36;  // half a name beyond the outer stations, at the usual size
constexpr double stationY_px = 14.0;
constexpr double nameY_px = stationY_px + 10.0;

constexpr std::array stations{Phase::opening, Phase::outerWall, Phase::basalTurn, Phase::full};

/// The largest font in which a name fits, within limits.
QFont fitting(const QString& name, QFont::Weight weight, int width, int largest_px)
{
  constexpr int smallest_px = 9;
  for (int size = largest_px; size > smallest_px; --size) {
    const QFont font = typeface(size, weight);
    if (QFontMetrics(font).horizontalAdvance(name) <= width) return font;
  }
  return typeface(smallest_px, weight);
}

}  // namespace

QString PhaseLine::nameOf(Phase phase) const
{
  switch (phase) {
    case Phase::opening:
      return tr("Opening");
    case Phase::outerWall:
      return tr("Outer wall");
    case Phase::basalTurn:
      return tr("Basal turn");
    case Phase::full:
      if (!isPartial_) return tr("Full depth");
      return isForVisitors_ ? tr("Goal") : tr("Stop");
    case Phase::outside:
      break;
  }
  return tr("Outside");
}

PhaseLine::PhaseLine(QWidget* parent) : QWidget(parent), name_px_(name_px)
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

void PhaseLine::setPartial(bool isPartial)
{
  if (isPartial == isPartial_) return;
  isPartial_ = isPartial;
  setAccessibleName(nameOf(phase_));
  update();
}

void PhaseLine::setForVisitors(int size_px)
{
  isForVisitors_ = true;
  name_px_ = size_px;
  updateGeometry();
  update();
}

int PhaseLine::nameHeight() const { return sized(4 * name_px_ / 3 + 4); }

int PhaseLine::lengthOf(int usual_px) const { return sized(usual_px * name_px_ / name_px); }

QString PhaseLine::tipAt(const QPoint& place) const
{
  const int margin = lengthOf(sideMargin_px);
  const double step = double(width() - 2 * margin) / double(stations.size() - 1);
  const double nearest = std::round((place.x() - margin) / step);
  const double offset = place.x() - margin - nearest * step;
  if (std::abs(offset) > margin) return {};
  switch (stations[std::size_t(std::clamp(nearest, 0.0, double(stations.size() - 1)))]) {
    case Phase::opening:
      return tr("The tip is inside the opening and the array does not contact the wall beyond it.");
    case Phase::outerWall:
      return tr("The array contacts the outer wall and slides along it.");
    case Phase::basalTurn:
      return tr("The tip is %1° or more past the round window.")
          .arg(inDegrees(analysis::basalTurnAngle), 0, 'f', 0);
    case Phase::full:
      return isPartial_ ? tr("The stop travel is reached; part of the array stays outside.")
                        : tr("The array is fully inserted.");
    case Phase::outside:
      break;
  }
  return {};
}

QSize PhaseLine::sizeHint() const
{
  constexpr int smallest_px = 38;  // its points do not shrink as its texts do
  return {480, std::max(int(nameY_px) + nameHeight(), smallest_px)};
}

/// Every name fits into its place in the size chosen: visitors cannot read smaller ones.
bool PhaseLine::areNamesWhole(int available_px) const
{
  const QFontMetrics metrics(typeface(name_px_, QFont::DemiBold));
  return std::all_of(stations.begin(), stations.end(), [&](Phase station) {
    return metrics.horizontalAdvance(nameOf(station)) <= available_px;
  });
}

void PhaseLine::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  paintPlate(painter, rect());

  const int margin = lengthOf(sideMargin_px);
  const double step = double(width() - 2 * margin) / double(stations.size() - 1);
  const QColor ahead = shownTheme().ahead;
  const int available = std::max(1, int(step) - 4);
  const bool namesOnlyPresent = isForVisitors_ && !areNamesWhole(available);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const QPointF place(margin + double(i) * step, stationY_px);
    const bool isReached = phase_ >= stations[i];
    const bool isHere = phase_ == stations[i];
    if (i + 1 < stations.size()) {
      const bool isPassed = phase_ >= stations[i + 1];
      painter.setPen(QPen(isPassed ? shownTheme().accent : ahead, 2.0));
      painter.drawLine(place + QPointF(8, 0), place + QPointF(step - 8, 0));
    }
    painter.setPen(QPen(isReached ? shownTheme().accent : ahead, 2.0));
    painter.setBrush(isReached ? QBrush(shownTheme().accent) : QBrush(Qt::NoBrush));
    const double radius = (isHere ? 6.5 : 4.5) * (isForVisitors_ ? 1.5 : 1.0);
    painter.drawEllipse(place, radius, radius);

    if (!isHere && namesOnlyPresent) continue;
    const int room = namesOnlyPresent ? width() : available;
    const QString caption = nameOf(stations[i]);
    painter.setFont(fitting(caption, isHere ? QFont::DemiBold : QFont::Normal, room, name_px_));
    painter.setPen(isHere ? shownTheme().text : shownTheme().quietText);
    const int width = QFontMetrics(painter.font()).horizontalAdvance(caption);
    QRectF name(place.x() - margin, nameY_px, 2 * margin, nameHeight());
    if (namesOnlyPresent)  // as near to its station as the edges permit
      name.moveLeft(
          std::clamp(name.left(), 0.5 * width - margin,
                     std::max(0.5 * width - margin, this->width() - 0.5 * width - margin)));
    painter.drawText(name, Qt::AlignCenter | Qt::TextDontClip,
                     QFontMetrics(painter.font()).elidedText(caption, Qt::ElideRight, room));
  }
}

}  // namespace perilymph::gui
