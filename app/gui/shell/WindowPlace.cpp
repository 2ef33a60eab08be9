// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/WindowPlace.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>
#include <algorithm>

#include "gui/run/UserSettings.h"

namespace perilymph::gui {

namespace {

constexpr auto geometryKey = "window/geometry";

// Reserved for the frame, which is unknown before a window is shown: the title bars of GNOME and
// KDE are 37 and 30 px high (Adwaita and Breeze in Debian 12), borders at most 8 px wide.
constexpr QSize frameAllowance{16, 48};

}  // namespace

InitialSize initialSize(const QRect& available)
{
  const QSize largest = available.size() - frameAllowance;
  const bool fits = preferredWindowSize.boundedTo(largest) == preferredWindowSize;
  return {preferredWindowSize.boundedTo(largest), preferredMinimumSize.boundedTo(largest), !fits};
}

double fittingTextScale(double wanted, const QRect& available)
{
  const QSize largest = available.size() - frameAllowance;
  const double fit = std::min({1.0, double(largest.width()) / preferredMinimumSize.width(),
                               double(largest.height()) / preferredMinimumSize.height()});
  return wanted * std::max(fit, 0.5);
}

void restorePlace(QWidget& window)
{
  const QScreen* screen = QGuiApplication::primaryScreen();
  if (screen == nullptr) return;
  const InitialSize initial = initialSize(screen->availableGeometry());
  window.setMinimumSize(initial.minimum);
  if (window.restoreGeometry(UserSettings().value(QLatin1String(geometryKey)).toByteArray()))
    return;
  window.resize(initial.size);
  if (initial.isMaximized) window.setWindowState(window.windowState() | Qt::WindowMaximized);
}

void keepPlace(const QWidget& window)
{
  UserSettings().setValue(QLatin1String(geometryKey), window.saveGeometry());
}

}  // namespace perilymph::gui
