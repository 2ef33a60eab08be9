#include "ForceWords.h"

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
  return meaning.isBeyond ? QStringLiteral("▲ ") + meaning.words : meaning.words;
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
    return {ForceWords::tr("below the %1 mN that surgeons feel").arg(felt), false};
  if (!known.peaks || size < known.peaks->low)
    return {ForceWords::tr("felt by surgeons, above %1 mN").arg(felt), false};
  const QString low = millinewtonsText(known.peaks->low);
  const QString high = millinewtonsText(known.peaks->high);
  if (size <= known.peaks->high)
    return {ForceWords::tr("felt; like peaks in patients, %1 to %2 mN").arg(low, high), false};
  return {ForceWords::tr("felt; above the peaks in patients, %1 mN").arg(high), true};
}

ForceMeaning meaningOnPartition(Force force, const ForceThresholds& known)
{
  const QString now = numberText(inMillinewtons(force), 0);
  if (!known.rupture) return {ForceWords::tr("on the partition %1 mN").arg(now), false};
  const QString low = millinewtonsText(known.rupture->low);
  const QString high = millinewtonsText(known.rupture->high);
  if (force.si() < known.rupture->low)
    return {
        ForceWords::tr("on the partition %1 mN; it ruptures at %2 to %3 mN").arg(now, low, high),
        false};
  return {ForceWords::tr("on the partition %1 mN: it ruptures at %2 to %3 mN").arg(now, low, high),
          true};
}

ForceWords::ForceWords(QWidget* parent) : QWidget(parent), known_(ForceThresholds::shipped())
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

void ForceWords::show(Force onHand, Force onPartition)
{
  ForceMeaning hand = meaningOnHand(onHand, known_);
  ForceMeaning partition = meaningOnPartition(onPartition, known_);
  if (hand.words == hand_.words && partition.words == partition_.words) return;
  hand_ = std::move(hand);
  partition_ = std::move(partition);
  setAccessibleName(hand_.words + QStringLiteral("; ") + partition_.words);
  updateGeometry();
  update();
}

QSize ForceWords::sizeHint() const
{
  const QFontMetrics metrics(font());
  const int widest = std::max(metrics.horizontalAdvance(marked(hand_)),
                              metrics.horizontalAdvance(marked(partition_)));
  return {widest + 2 * plate_px, 2 * lineHeight_px + plate_px};
}

void ForceWords::paintEvent(QPaintEvent*)
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
