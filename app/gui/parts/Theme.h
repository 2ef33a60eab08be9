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
  QColor border;  ///< Edges of fields and buttons; 3:1 on the background.
  QColor ahead;   ///< Remaining part of a progress line; 3:1 on the background.
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
inline const QColor& borderColor = shownTheme().border;
inline const QColor& aheadColor = shownTheme().ahead;
inline const QColor& textColor = shownTheme().text;
inline const QColor& quietTextColor = shownTheme().quietText;
inline const QColor& accentColor = shownTheme().accent;
inline const QColor& ghostColor = shownTheme().ghost;
inline const QColor& warningColor = shownTheme().warning;
inline const QColor& alarmColor = shownTheme().alarm;

/// Size of text over its standard size, 0.9 to 1.5; chosen before a window is made.
double textScale();
void setTextScale(double scale);
/// A length that grows with the text: heights of fields and buttons, widths of panels [px].
int sized(int size_px);

/// Lengths of the window that grow with its text [px].
struct Lengths {
  int sidePanel = 248, chartColumn = 431;
  int minChartColumn = 300;  ///< Minimum width, to leave space for the 3D view.
  int bar = 44;
};
const Lengths& shownLengths();

inline const int& sidePanelWidth = shownLengths().sidePanel;
inline const int& chartColumnWidth = shownLengths().chartColumn;
inline const int& minChartColumnWidth = shownLengths().minChartColumn;
inline const int& barHeight = shownLengths().bar;
inline constexpr int spacing = 8;
/// Opacity of the background of text over the 3D view: text has 4.5:1 over anything behind it.
inline constexpr int plateAlpha = 235;

/// Inter at a standard size [px], scaled by textScale(), or DejaVu Sans if Inter is missing.
QFont typeface(int size_px, QFont::Weight weight = QFont::Normal);

/// Paints the plate behind text over the 3D view, which keeps it legible; leaves no pen.
void paintPlate(QPainter& painter, const QRect& area);

/// The style sheet of the whole window.
QString windowStyle();

}  // namespace perilymph::gui
