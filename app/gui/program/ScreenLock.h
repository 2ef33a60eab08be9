// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reports that the screen was locked, so that a haptic device can be stopped.

#include <QDBusConnection>
#include <QObject>
#include <QVariantMap>

namespace perilymph::gui {

/// Listens on D-Bus to what locks a screen: logind on the system bus (Lock, LockedHint of a
/// session), and the screen savers of the desktops on the session bus (ActiveChanged). Without a
/// bus it never reports anything.
class ScreenLock : public QObject {
  Q_OBJECT
public:
  explicit ScreenLock(QObject* parent)
      : ScreenLock(QDBusConnection::systemBus(), QDBusConnection::sessionBus(), parent)
  {
  }
  ScreenLock(QDBusConnection system, QDBusConnection session, QObject* parent);

Q_SIGNALS:
  void locked();

private Q_SLOTS:
  void takeActive(bool isActive);
  void takeProperties(const QString& interface, const QVariantMap& changed);
};

}  // namespace perilymph::gui
