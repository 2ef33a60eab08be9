#include "ForceInterpretation.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "Numbers.h"
#include "Theme.h"

namespace perilymph::gui {

namespace {

constexpr int lineHeight_px = 18;
constexpr int plate_px = 6;

QString millinewtonsText(double force_N) { return numberText(force_N * 1e3, 0); }

std::optional<analysis::PrintedRange> rangeOf(const char* reference, const char* quantity)
{
  const auto loaded = analysis::shippedReference(reference);
  if (!loaded) return std::nullopt;
  const analysis::PrintedRange* range = loaded->findRange(quantity);
  return range == nullptr ? std::nullopt : std::optional(*range);
}

QString marked(const ForceMeaning& meaning)
{
  return meaning.isBeyond ? QStringLiteral("▲ ") + meaning.text : meaning.text;
}

}  // namespace

ForceThresholds ForceThresholds::shipped()
{
  ForceThresholds known;
  known.peaks = rangeOf("in-vivo", "peak");
  known.rupture = rangeOf("in-vitro", "rupture of the partition");
  return known;
}

ForceMeaning meaningOnHand(Force force, const ForceThresholds& known)
{
  const double size = std::fabs(force.si());
  const QString felt = numberText(inMillinewtons(known.felt), 0);
  if (size < known.felt.si())
    return {ForceInterpretation::tr("below the %1 mN that surgeons feel").arg(felt), false};
  if (!known.peaks || size < known.peaks->low)
    return {ForceInterpretation::tr("felt by surgeons, above %1 mN").arg(felt), false};
  const QString low = millinewtonsText(known.peaks->low);
  const QString high = millinewtonsText(known.peaks->high);
  if (size <= known.peaks->high)
    return {ForceInterpretation::tr("felt; like peaks in patients, %1 to %2 mN").arg(low, high),
            false};
  return {ForceInterpretation::tr("felt; above the peaks in patients, %1 mN").arg(high), true};
}

ForceMeaning meaningOnPartition(Force force, const ForceThresholds& known)
{
  const QString now = numberText(inMillinewtons(force), 0);
  if (!known.rupture) return {ForceInterpretation::tr("on the partition %1 mN").arg(now), false};
  const QString low = millinewtonsText(known.rupture->low);
  const QString high = millinewtonsText(known.rupture->high);
  if (force.si() < known.rupture->low)
    return {ForceInterpretation::tr("on the partition %1 mN; it ruptures at %2 to %3 mN")
                .arg(now, low, high),
            false};
  return {ForceInterpretation::tr("on the partition %1 mN: it ruptures at %2 to %3 mN")
              .arg(now, low, high),
          true};
}

ForceInterpretation::ForceInterpretation(QWidget* parent)
    : QWidget(parent), known_(ForceThresholds::shipped())
{
  setObjectName(QStringLiteral("forceWords"));
  setFont(typeface(12));
  setAttribute(Qt::WA_NoSystemBackground);
  QStringList sources{
      tr("Felt: median of ten otologic surgeons, 20.4 mN (Kratchman 2016, Audiol "
         "Neurotol 21:244).")};
  if (known_.peaks) sources << QString::fromStdString(known_.peaks->source);
  if (known_.rupture) sources << QString::fromStdString(known_.rupture->source);
  sources << tr(
      "The force on the partition is the sum of what the whole array presses normal to "
      "it; a rupture was measured under one point. No force is known to do no harm: "
      "trauma may occur below these forces (Mirsalehi 2017).");
  setToolTip(sources.join(QStringLiteral("\n\n")));
  show({}, {});
}

void ForceInterpretation::show(Force onHand, Force onPartition)
{
  ForceMeaning hand = meaningOnHand(onHand, known_);
  ForceMeaning partition = meaningOnPartition(onPartition, known_);
  if (hand.text == hand_.text && partition.text == partition_.text) return;
  hand_ = std::move(hand);
  partition_ = std::move(partition);
  setAccessibleName(hand_.text + QStringLiteral("; ") + partition_.text);
  updateGeometry();
  update();
}

QSize ForceInterpretation::sizeHint() const
{
  const QFontMetrics metrics(font());
  const int widest = std::max(metrics.horizontalAdvance(marked(hand_)),
                              metrics.horizontalAdvance(marked(partition_)));
  return {widest + 2 * plate_px, 2 * lineHeight_px + plate_px};
}

void ForceInterpretation::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor plate = groundColor;
  plate.setAlpha(plateAlpha);
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawRoundedRect(rect(), 6, 6);
  painter.setFont(font());
  QRect line(plate_px, plate_px / 2, width() - 2 * plate_px, lineHeight_px);
  for (const ForceMeaning* meaning : {&hand_, &partition_}) {
    painter.setPen(meaning->isBeyond ? warningColor : quietTextColor);
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, marked(*meaning));
    line.translate(0, lineHeight_px);
  }
}

}  // namespace perilymph::gui
