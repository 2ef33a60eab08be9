// SPDX-License-Identifier: BSD-3-Clause
#include "gui/text/DeviceRate.h"

#include <QCoreApplication>

#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* label) { return QCoreApplication::translate("perilymph::gui", label); }

QString milliseconds(double time) { return numberText(time * 1e3, 2); }

}  // namespace

QString roundTripText(const device::DeviceHealth& health)
{
  const QString time = milliseconds(health.roundTrip);
  return health.isRoundTripMeasured ? tr("round trip %1 ms").arg(time)
                                    : tr("round trip at most %1 ms").arg(time);
}

QString deviceRateText(const std::optional<device::DeviceHealth>& health)
{
  if (!health) return {};
  if (!health->isConnected) return tr("device disconnected");
  const device::ReadingFigures& reading = health->reading;
  QString text = tr("device %1 reports/s, jitter %2 ms")
                     .arg(numberText(reading.rate, 0),
                          milliseconds(reading.intervalP99 - reading.intervalMedian));
  if (health->roundTrip > 0.0) text += roundTripText(*health).prepend(QStringLiteral(", "));
  return text;
}

}  // namespace perilymph::gui
