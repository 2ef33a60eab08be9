// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Appearance of the window: colors, fonts and spacing.

#include <QColor>
#include <QFont>
#include <QString>

class QPainter;
class QRect;

namespace perilymph::gui {

/// Color schemes of the window.
enum class ColorScheme { dark, light };

/// Colors of a scheme. Text has a contrast of 4.5:1 or more on each of its backgrounds.
struct Theme {
  QColor ground;   ///< Views and input fields.
  QColor panel;    ///< The area around them.
  QColor raised;   ///< Buttons.
  QColor pressed;  ///< Draggable elements.
  QColor line;
  QColor ahead;  ///< Remaining part of a progress line; 3:1 on the background.
  QColor text, quietText;
  QColor accent;       ///< The current insertion, and the primary action.
  QColor accentHover;  ///< The same under the mouse.
  QColor onAccent;     ///< Text on both.
  QColor ghost;        ///< Other insertions: reference run, comparison.
  QColor warning;      ///< Always together with text.
  QColor onWarning;    ///< Text on it.
  QColor alarm;        ///< Color of a status light, always together with text.
  QColor banner;       ///< Background of error messages.
};

const Theme& themeOf(ColorScheme look);

/// The color scheme of all windows, charts and 3D views; chosen before a window is made.
ColorScheme shownColorScheme();
void setShownColorScheme(ColorScheme look);
/// The colors of the current scheme. The object is the same when the scheme changes.
const Theme& shownTheme();

inline const QColor& groundColor = shownTheme().ground;
inline const QColor& panelColor = shownTheme().panel;
inline const QColor& raisedColor = shownTheme().raised;
inline const QColor& lineColor = shownTheme().line;
inline const QColor& aheadColor = shownTheme().ahead;
inline const QColor& textColor = shownTheme().text;
inline const QColor& quietTextColor = shownTheme().quietText;
inline const QColor& accentColor = shownTheme().accent;
inline const QColor& ghostColor = shownTheme().ghost;
inline const QColor& warningColor = shownTheme().warning;
inline const QColor& alarmColor = shownTheme().alarm;

inline constexpr int sidePanelWidth = 248;
inline constexpr int chartColumnWidth = 431;
inline constexpr int minChartColumnWidth = 300;  ///< Minimum width, to leave space for the 3D view.
inline constexpr int barHeight = 44;
inline constexpr int spacing = 8;
inline constexpr int plateAlpha = 185;  ///< Opacity of the background of text over the 3D view.

/// Inter at a size [px], or DejaVu Sans if Inter is missing.
QFont typeface(int size_px, QFont::Weight weight = QFont::Normal);

/// Paints the plate behind text over the 3D view, which keeps it legible; leaves no pen.
void paintPlate(QPainter& painter, const QRect& area);

/// The style sheet of the whole window.
QString windowStyle();

}  // namespace perilymph::gui
