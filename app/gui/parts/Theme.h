#pragma once

// How the window looks: its colors, its type and its spacing, in one place.

#include <QColor>
#include <QFont>
#include <QString>

namespace perilymph::gui {

/// The two looks of the window.
enum class ColorScheme { dark, light };

/// The colors of a look. Text on every ground it lies on has a contrast of 4.5:1 or more.
struct Theme {
  QColor ground;   ///< Pictures and fields.
  QColor panel;    ///< Everything around them.
  QColor raised;   ///< Buttons.
  QColor pressed;  ///< What the mouse may drag.
  QColor line;
  QColor ahead;  ///< Remaining part of a progress line; 3:1 on the ground.
  QColor text, quietText;
  QColor accent;       ///< This insertion, and the primary action.
  QColor accentHover;  ///< The same under the mouse.
  QColor onAccent;     ///< Text on both.
  QColor ghost;        ///< Other insertions: ghost, comparison.
  QColor warning;      ///< Never without a word.
  QColor onWarning;    ///< Text on it.
  QColor alarm;        ///< A light's, never without a word.
  QColor banner;       ///< Behind what went wrong.
};

const Theme& themeOf(ColorScheme look);

/// The look of this program's windows, charts and pictures. One for all of them; it is chosen
/// before a window is made.
ColorScheme shownColorScheme();
void setShownColorScheme(ColorScheme look);
/// Its colors. The object stays where it is when the look changes.
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
inline constexpr int minChartColumnWidth = 300;  ///< Where the picture needs the room.
inline constexpr int barHeight = 44;
inline constexpr int spacing = 8;
inline constexpr int plateAlpha =
    185;  ///< Opacity of the ground behind text that lies on the picture.

/// Inter in a size [px], or DejaVu Sans where Inter is missing.
QFont typeface(int size_px, QFont::Weight weight = QFont::Normal);

/// The style sheet of the whole window.
QString windowStyle();

}  // namespace perilymph::gui
