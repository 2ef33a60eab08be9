// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/ForceLabel.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int plate_px = 6;

QString marked(const ForceMeaning& meaning)
{
  return meaning.isBeyond ? QStringLiteral("▲ ") + meaning.text : meaning.text;
}

}  // namespace

ForceLabel::ForceLabel(QWidget* parent) : QWidget(parent), known_(ForceThresholds::shipped())
{
  setObjectName(QStringLiteral("forceWords"));
  setFont(typeface(12));
  setAttribute(Qt::WA_NoSystemBackground);
  QStringList sources;
  if (known_.felt)
    sources << tr("Perception threshold: median of ten otologic surgeons, %1 mN (Kratchman et al. "
                  "2016, Audiol Neurotol 21:244).")
                   .arg(numberText(inMillinewtons(*known_.felt), 1));
  if (known_.peaks) sources << QString::fromStdString(known_.peaks->source);
  if (known_.rupture) sources << QString::fromStdString(known_.rupture->source);
  sources << tr(
      "The partition force is the largest force normal to the cochlear partition, bone and "
      "membrane, "
      "within one width of the array: that at which the partition ruptures in the simulation. "
      "Rupture "
      "was measured under a point load. No force is known to be safe: trauma "
      "may occur below these forces (Mirsalehi et al. 2017).");
  sources_ = sources.join(QStringLiteral("\n\n"));
  show({});
}

void ForceLabel::show(const haptics::TickOutput& now)
{
  ForceMeaning hand = meaningOnHand(Force::fromSi(now.axialForce), known_);
  ForceMeaning partition = now.translocation.force > 0.0
                               ? meaningOfRupture(now.translocation)
                               : meaningOnPartition(Force::fromSi(now.partitionForce), known_);
  if (hand.text == hand_.text && partition.text == partition_.text) return;
  hand_ = std::move(hand);
  partition_ = std::move(partition);
  setAccessibleName(hand_.text + QStringLiteral("; ") + partition_.text);
  setToolTip(marked(hand_) + QStringLiteral("\n") + marked(partition_) + QStringLiteral("\n\n") +
             sources_);
  updateGeometry();
  update();
}

int ForceLabel::lineHeight() const { return font().pixelSize() * 3 / 2; }

QSize ForceLabel::sizeHint() const
{
  const QFontMetrics metrics(font());
  const int widest = std::max(metrics.horizontalAdvance(marked(hand_)),
                              metrics.horizontalAdvance(marked(partition_)));
  return {widest + 2 * plate_px + 2, 2 * lineHeight() + plate_px};
}

void ForceLabel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  paintPlate(painter, rect());
  painter.setFont(font());
  QRect line(plate_px, plate_px / 2, width() - 2 * plate_px, lineHeight());
  for (const ForceMeaning* meaning : {&hand_, &partition_}) {
    painter.setPen(meaning->isBeyond ? shownTheme().warning : shownTheme().quietText);
    painter.drawText(
        line, Qt::AlignRight | Qt::AlignVCenter,
        QFontMetrics(font()).elidedText(marked(*meaning), Qt::ElideRight, line.width()));
    line.translate(0, lineHeight());
  }
}

}  // namespace perilymph::gui
