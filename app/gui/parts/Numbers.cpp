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

}  // namespace perilymph::gui
