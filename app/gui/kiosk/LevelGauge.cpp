// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/LevelGauge.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

/// The gauge ends at this multiple of the upper bound, so that the third zone is as high as the second
/// is (choice).
constexpr double endOverBound = 1.5;
constexpr double filledOpacity = 1.0, emptyOpacity = 0.16;

/// The ink of text on a color: the darker or lighter of two, whichever has the larger contrast.
QColor inkOn(const QColor& ground) { return ground.lightnessF() > 0.42 ? Qt::black : Qt::white; }

}  // namespace

LevelGauge::LevelGauge(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("levelGauge"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void LevelGauge::setRange(std::optional<analysis::PrintedRange> measured)
{
  measured_ = std::move(measured);
  update();
}

void LevelGauge::setLetterSize(int size_px)
{
  letter_px_ = size_px;
  update();
}

void LevelGauge::show(double force_N, double peak_N)
{
  if (force_N == force_N_ && peak_N == peak_N_) return;
  force_N_ = force_N;
  peak_N_ = peak_N;
  if (measured_) setAccessibleName(wordOf(*level()));
  update();
}

std::optional<ForceLevel> LevelGauge::level() const
{
  if (!measured_) return std::nullopt;
  return levelOf(force_N_, *measured_);
}

double LevelGauge::share(double force_N) const
{
  return std::clamp(force_N / (endOverBound * measured_->high), 0.0, 1.0);
}

void LevelGauge::paintZone(QPainter& painter, ForceLevel zone, const QRectF& place) const
{
  const bool isHere = zone == level();
  const QColor color = colorOf(zone);
  QPainterPath plate;
  plate.addRoundedRect(place, 8, 8);
  painter.setOpacity(isHere ? filledOpacity : emptyOpacity);
  painter.fillPath(plate, color);
  painter.setOpacity(1.0);
  painter.setPen(QPen(color, 2.0));
  painter.drawPath(plate);
  painter.setPen(isHere ? inkOn(color) : shownTheme().text);
  painter.setFont(typeface(letter_px_, isHere ? QFont::Bold : QFont::Normal));
  painter.drawText(place, Qt::AlignCenter, signOf(zone) + QStringLiteral(" ") + wordOf(zone));
}

/// A filled pointer at the force now, a hollow one at the largest so far.
void LevelGauge::paintMarks(QPainter& painter, const QRectF& bar) const
{
  const double half = 0.45 * sized(letter_px_);
  const double y = bar.bottom() - share(std::max(0.0, force_N_)) * bar.height();
  QPainterPath pointer(QPointF(bar.left() - 2.0, y));
  pointer.lineTo(bar.left() - 2.0 - 1.6 * half, y - half);
  pointer.lineTo(bar.left() - 2.0 - 1.6 * half, y + half);
  pointer.closeSubpath();
  painter.fillPath(pointer, shownTheme().text);

  if (!(peak_N_ > 0.0)) return;
  const double top = bar.bottom() - share(peak_N_) * bar.height();
  QPainterPath peak(QPointF(bar.right() + 2.0, top));
  peak.lineTo(bar.right() + 2.0 + 1.6 * half, top - half);
  peak.lineTo(bar.right() + 2.0 + 1.6 * half, top + half);
  peak.closeSubpath();
  painter.setPen(QPen(shownTheme().text, 2.5));
  painter.drawPath(peak);
}

void LevelGauge::paintNumber(QPainter& painter, const QRectF& place) const
{
  painter.setPen(shownTheme().text);
  painter.setFont(typeface(letter_px_));
  const QString now = numberText(inMillinewtons(newtons(force_N_)), 0);
  const QString peak = numberText(inMillinewtons(newtons(peak_N_)), 0);
  painter.drawText(place, Qt::AlignHCenter | Qt::AlignTop,
                   QStringLiteral("▶ ") + tr("now %1 mN").arg(now));
  painter.drawText(place, Qt::AlignHCenter | Qt::AlignBottom,
                   QStringLiteral("◁ ") + tr("peak %1 mN").arg(peak));
}

void LevelGauge::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double letter = sized(letter_px_);
  const QRectF all = QRectF(rect()).adjusted(2, 2, -2, -2);
  const double numbers = 2.6 * letter;
  paintNumber(painter, {all.left(), all.bottom() - numbers, all.width(), numbers});
  if (!measured_) return;
  const QRectF bar = all.adjusted(letter, 0, -letter, -numbers - 0.3 * letter);
  constexpr double gap = 2.0;
  double bottom = bar.bottom();
  for (const auto& [zone, end] :
       {std::pair{ForceLevel::gentle, share(measured_->low)},
        std::pair{ForceLevel::firm, share(measured_->high)}, std::pair{ForceLevel::tooMuch, 1.0}}) {
    const double top = bar.bottom() - end * bar.height();
    paintZone(painter, zone, {bar.left(), top + gap, bar.width(), bottom - top - 2 * gap});
    bottom = top;
  }
  paintMarks(painter, bar);
}

}  // namespace perilymph::gui
