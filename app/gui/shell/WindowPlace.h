// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Size and position of the window on the screen.

#include <QRect>
#include <QSize>

class QWidget;

namespace perilymph::gui {

/// Size of a window that has not been resized by the user.
inline constexpr QSize preferredWindowSize{1280, 800};
/// Minimum size of the window on screens that are large enough for it.
inline constexpr QSize preferredMinimumSize{1024, 640};

/// Size of a new window on a screen.
struct InitialSize {
  QSize size;
  QSize minimum;
  bool isMaximized = false;  ///< The preferred size does not fit with its frame.
};

/// @param available  Area of the screen without panels [px]. The window and its frame lie within it.
InitialSize initialSize(const QRect& available);

/// Text scale with which a window of the minimum size fits on a screen: less than wanted on a small screen
/// that is scaled up.
double fittingTextScale(double wanted, const QRect& available);

/// Restores size and position from the settings; a first window is placed within its screen.
void restorePlace(QWidget& window);
/// Stores size and position in the settings.
void keepPlace(const QWidget& window);

}  // namespace perilymph::gui
