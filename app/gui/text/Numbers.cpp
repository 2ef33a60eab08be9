// SPDX-License-Identifier: BSD-3-Clause
#include "gui/text/Numbers.h"

#include <QLocale>
#include <cmath>

namespace perilymph::gui {

QString numberText(double value, int decimals)
{
  const double power = std::pow(10.0, decimals);
  const double rounded = std::round(value * power) / power;
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(rounded == 0.0 ? 0.0 : rounded, 'f', decimals);
}

int forceDecimals(double largest_mN) { return std::fabs(largest_mN) < 9.95 ? 1 : 0; }

QString forceNumber(double force_mN) { return numberText(force_mN, forceDecimals(force_mN)); }

QString kilohertzText(double frequency_Hz)
{
  constexpr double kilo = 1e3;
  return numberText(frequency_Hz / kilo, frequency_Hz < 9.995 * kilo ? 2 : 1);
}

std::optional<double> typedNumber(const QString& text)
{
  // Locales differ in the decimal and the thousands separator; read with a German locale, 34.125 mm
  // would be thirty-four thousand.
  QString plain = text.trimmed();
  plain.replace(QLatin1Char(','), QLatin1Char('.'));
  if (plain.count(QLatin1Char('.')) > 1) return std::nullopt;
  bool isNumber = false;
  double number = QLocale::c().toDouble(plain, &isNumber);
  if (!isNumber) {
    QLocale locale;  // other digits
    locale.setNumberOptions(QLocale::RejectGroupSeparator);
    number = locale.toDouble(text.trimmed(), &isNumber);
  }
  if (!isNumber || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace perilymph::gui
