// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/UserSettings.h"

#include <spdlog/spdlog.h>

#include <QStringList>
#include <QVariant>

namespace perilymph::gui {

UserSettings::UserSettings()
    : QSettings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("perilymph"),
                QStringLiteral("perilymph"))
{
  setFallbacksEnabled(false);
  const QString key = QStringLiteral("format");
  const bool isDamaged = status() == QSettings::FormatError;
  const bool isNew = allKeys().isEmpty() && !isDamaged;
  if (!isNew && (isDamaged || value(key).toInt() != format)) {
    spdlog::warn("The settings in {} are {}; the window begins with its own.",
                 fileName().toStdString(),
                 isDamaged ? "damaged"
                           : "of format " + value(key).toString().toStdString() +
                                 ", this program reads " + std::to_string(format));
    clear();
  }
  if (value(key).toInt() != format) setValue(key, format);
}

QString UserSettings::word(const QString& key, const QStringList& allowed, int unset) const
{
  const QString found = value(key, allowed[unset]).toString();
  if (allowed.contains(found)) return found;
  spdlog::warn("The setting {} is '{}'; allowed are: {}. It counts as not set.", key.toStdString(),
               found.toStdString(), allowed.join(QStringLiteral(", ")).toStdString());
  return allowed[unset];
}

}  // namespace perilymph::gui
