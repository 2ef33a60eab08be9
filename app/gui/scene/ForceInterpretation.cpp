// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/ForceInterpretation.h"

#include <QCoreApplication>
#include <cmath>
#include <optional>

#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString millinewtonsText(double force_N) { return numberText(force_N * 1e3, 0); }

std::optional<analysis::PrintedRange> rangeOf(const char* reference, const char* quantity)
{
  const auto loaded = analysis::shippedReference(reference);
  if (!loaded) return std::nullopt;
  const analysis::PrintedRange* range = loaded->findRange(quantity);
  return range == nullptr ? std::nullopt : std::optional(*range);
}

}  // namespace

ForceThresholds ForceThresholds::shipped()
{
  ForceThresholds known;
  if (const auto felt = analysis::forceFeltBySurgeons()) known.felt = *felt;
  if (const auto peaks = analysis::peaksInPatients()) known.peaks = *peaks;
  known.rupture = rangeOf("in-vitro", "rupture of the partition");
  return known;
}

ForceMeaning meaningOnHand(Force force, const ForceThresholds& known)
{
  const double size = std::fabs(force.si());
  const QString felt = known.felt ? numberText(inMillinewtons(*known.felt), 0) : QString();
  if (known.felt && size < known.felt->si())
    return {tr("below perception threshold (%1 mN)").arg(felt), false};
  if (!known.felt && (!known.peaks || size < known.peaks->low)) return {};
  if (!known.peaks || size < known.peaks->low)
    return {tr("perceptible (above %1 mN)").arg(felt), false};
  const QString low = millinewtonsText(known.peaks->low);
  const QString high = millinewtonsText(known.peaks->high);
  if (size <= known.peaks->high)
    return {tr("perceptible; within reported clinical peak forces (%1–%2 mN)").arg(low, high),
            false};
  return {tr("above reported clinical peak forces (> %1 mN)").arg(high), true};
}

ForceMeaning meaningOnPartition(Force force, const ForceThresholds& known)
{
  if (std::isnan(force.si())) return {tr("force on the cochlear partition not recorded"), false};
  const QString now = numberText(inMillinewtons(force), 0);
  if (!known.rupture) return {tr("cochlear partition %1 mN").arg(now), false};
  const QString low = millinewtonsText(known.rupture->low);
  const QString high = millinewtonsText(known.rupture->high);
  if (force.si() < known.rupture->low)
    return {tr("cochlear partition %1 mN (rupture assumed at %2–%3 mN)").arg(now, low, high),
            false};
  return {tr("cochlear partition %1 mN: within or above assumed rupture forces (%2–%3 mN)")
              .arg(now, low, high),
          true};
}

ForceMeaning meaningOfRupture(const haptics::Translocation& rupture)
{
  const QString angle = numberText(inDegrees(Angle::fromSi(rupture.angle)), 0);
  const QString force = numberText(inMillinewtons(Force::fromSi(rupture.force)), 0);
  if (!(rupture.lengthAbove > 0.0))
    return {tr("cochlear partition ruptured at %1° by %2 mN").arg(angle, force), true};
  const QString length = numberText(inMillimeters(Length::fromSi(rupture.lengthAbove)), 1);
  return {tr("translocation: partition ruptured at %1° by %2 mN, %3 mm above it")
              .arg(angle, force, length),
          true};
}

}  // namespace perilymph::gui
