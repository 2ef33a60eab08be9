// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/ScreenLock.h"

namespace perilymph::gui {

namespace {

// org.freedesktop.login1(5), "Session objects".
const QString login = QStringLiteral("org.freedesktop.login1");
const QString loginSession = QStringLiteral("org.freedesktop.login1.Session");

}  // namespace

ScreenLock::ScreenLock(QDBusConnection system, QDBusConnection session, QObject* parent)
    : QObject(parent)
{
  // Any session of this machine: one that is locked elsewhere stops a device needlessly, which is
  // safe.
  system.connect(login, {}, loginSession, QStringLiteral("Lock"), this, SIGNAL(locked()));
  system.connect(login, {}, QStringLiteral("org.freedesktop.DBus.Properties"),
                 QStringLiteral("PropertiesChanged"), this,
                 SLOT(takeProperties(QString, QVariantMap)));
  // The interface of the Idle Inhibition Service draft, and those of desktops that have their own.
  for (const char* desktop : {"freedesktop", "gnome", "cinnamon", "mate", "xfce"})
    session.connect({}, {}, QStringLiteral("org.%1.ScreenSaver").arg(QLatin1String(desktop)),
                    QStringLiteral("ActiveChanged"), this, SLOT(takeActive(bool)));
}

void ScreenLock::takeActive(bool isActive)
{
  if (isActive) Q_EMIT locked();
}

void ScreenLock::takeProperties(const QString& interface, const QVariantMap& changed)
{
  if (interface == loginSession && changed.value(QStringLiteral("LockedHint")).toBool())
    Q_EMIT locked();
}

}  // namespace perilymph::gui
