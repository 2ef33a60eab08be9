// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportIssuer.h"

#include <spdlog/spdlog.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QImageReader>
#include <QLocale>
#include <QRegularExpression>

#include "gui/run/UserSettings.h"

namespace perilymph::gui {

namespace {

constexpr int maxLogo_px = 4096;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// "UTC", or "UTC+01:00".
QString offsetText(int seconds)
{
  if (seconds == 0) return QStringLiteral("UTC");
  const int minutes = std::abs(seconds) / 60;
  return QStringLiteral("UTC%1%2:%3")
      .arg(seconds < 0 ? QStringLiteral("−") : QStringLiteral("+"))
      .arg(minutes / 60, 2, 10, QLatin1Char('0'))
      .arg(minutes % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace

Result<QImage> readLogo(const QString& file)
{
  QImageReader reader(file);
  const QSize size = reader.size();
  const bool isKnown = reader.format() == "png" || reader.format() == "jpeg";
  const bool isSmall = size.width() <= maxLogo_px && size.height() <= maxLogo_px;
  const QImage logo = isKnown && isSmall ? reader.read() : QImage();
  if (!logo.isNull()) return logo;
  return Error{tr("%1 cannot be used as a logo; choose a PNG or JPEG of at most %2 × %2 pixels.")
                   .arg(file)
                   .arg(maxLogo_px)
                   .toStdString()};
}

ReportIssuer ReportIssuer::fromSettings()
{
  const UserSettings settings;
  ReportIssuer issuer{settings.value(QStringLiteral("report/institution")).toString().trimmed(),
                      settings.value(QStringLiteral("report/operator")).toString().trimmed(),
                      {}};
  const QString file = settings.value(QStringLiteral("report/logo")).toString().trimmed();
  if (file.isEmpty()) return issuer;
  if (const auto logo = readLogo(file))
    issuer.logo = *logo;
  else
    spdlog::warn("{}", logo.error().message);
  return issuer;
}

QString localTimeOf(const std::string& utc)
{
  const QDateTime time =
      QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate).toLocalTime();
  if (!time.isValid()) return QString::fromStdString(utc);
  const QLocale locale;
  QString format = locale.dateFormat(QLocale::LongFormat);
  format.remove(QRegularExpression(QStringLiteral("dddd,? ?")));  // the day of the week
  return tr("%1, %2 (%3)")
      .arg(locale.toString(time.date(), format), time.time().toString(QStringLiteral("HH:mm")),
           offsetText(time.offsetFromUtc()));
}

}  // namespace perilymph::gui
