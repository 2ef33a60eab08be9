#pragma once

// How the window looks: its colors, its type and its spacing, in one place.

#include <QColor>
#include <QFont>
#include <QString>

namespace perilymph::gui {

/// The dark theme. Text on every ground has a contrast of 4.5:1 or more.
inline const QColor groundColor{0x12, 0x16, 0x1A};
inline const QColor panelColor{0x1A, 0x20, 0x26};
inline const QColor raisedColor{0x26, 0x31, 0x3A};  ///< Buttons.
inline const QColor lineColor{0x2A, 0x32, 0x3A};
inline const QColor textColor{0xE8, 0xEC, 0xEF};
inline const QColor quietTextColor{0x93, 0xA1, 0xAC};
inline const QColor accentColor{0x45, 0xC4, 0xB0};   ///< This insertion, and the primary action.
inline const QColor ghostColor{0x56, 0xB4, 0xE9};    ///< Other insertions: ghost, comparison.
inline const QColor warningColor{0xE6, 0x9F, 0x00};  ///< Never without a word.
inline const QColor alarmColor{0xD5, 0x5E, 0x00};    ///< Never without a word.

inline constexpr int sidePanelWidth = 248;
inline constexpr int chartColumnWidth = 431;
inline constexpr int barHeight = 44;
inline constexpr int spacing = 8;
inline constexpr int plateAlpha = 185;  ///< Of the ground behind words that lie on the picture.

/// Inter in a size [px], or DejaVu Sans where Inter is missing.
QFont typeface(int size_px, QFont::Weight weight = QFont::Normal);

/// The style sheet of the whole window.
QString windowStyle();

}  // namespace perilymph::gui
