#include "Settings.h"

namespace perilymph::gui {

Settings::Settings()
    : QSettings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("perilymph"),
                QStringLiteral("perilymph"))
{
  const QString key = QStringLiteral("format");
  const int found = value(key, format).toInt();
  if (found < format) clear();
  if (!contains(key) || found < format) setValue(key, format);
}

}  // namespace perilymph::gui
