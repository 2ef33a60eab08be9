// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/ReportHead.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>

#include "gui/parts/UserSettings.h"

namespace perilymph::gui {

namespace {

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

ReportIssuer ReportIssuer::fromSettings()
{
  const UserSettings settings;
  return {settings.value(QStringLiteral("report/institution")).toString().trimmed(),
          settings.value(QStringLiteral("report/operator")).toString().trimmed()};
}

QString subjectOf(const ReportContent& content)
{
  const bool isLeft = content.scenario.patient().side == anatomy::Side::left;
  const QString ear = isLeft ? tr("left ear") : tr("right ear");
  if (!content.hasPatient()) return tr("No patient · %1").arg(ear);
  return tr("Patient %1 · %2").arg(QString::fromStdString(content.scenario.patient().label), ear);
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
