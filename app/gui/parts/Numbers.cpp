#include "Numbers.h"

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

std::optional<double> typedNumber(const QString& text)
{
  bool isNumber = false;
  const QString trimmed = text.trimmed();
  double number = QLocale().toDouble(trimmed, &isNumber);
  if (!isNumber) number = QLocale::c().toDouble(trimmed, &isNumber);
  if (!isNumber || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace perilymph::gui
