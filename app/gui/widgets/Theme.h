// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Appearance of the window: colors, fonts and spacing.

#include <QColor>
#include <QFont>
#include <QString>

#include "perilymph/figures/Palette.h"

class QPainter;
class QRect;

namespace perilymph::gui {

using figures::ColorScheme;

/// The palette's colors of widgets (figures/Palette.h says what each is for).
struct Theme {
  QColor ground, panel, raised, pressed, banner;
  QColor line, border, ahead;
  QColor text, quietText;
  QColor accent, accentHover, onAccent;
  QColor ghost, pink;  ///< Other insertions: reference run, comparison.
  QColor warning, onWarning, alarm;
  QColor stop, stopPressed, onStop;
  QColor bone, lumen, silicone, platinum;
};

/// A color of the palette.
QColor colorOf(const figures::Ink& ink);

/// The colors of a scheme: constants of the program.
const Theme& themeOf(ColorScheme look);

/// The color scheme of all windows, charts and 3D views; chosen before a window is made.
ColorScheme shownColorScheme();
void setShownColorScheme(ColorScheme look);
/// The colors of that scheme.
const Theme& shownTheme();

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
