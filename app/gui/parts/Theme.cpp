// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/Theme.h"

#include <QPainter>
#include <QStringList>

namespace perilymph::gui {

namespace {

const Theme& darkTheme()
{
  static const Theme theme{
      .ground = {0x12, 0x16, 0x1A},
      .panel = {0x1A, 0x20, 0x26},
      .raised = {0x26, 0x31, 0x3A},
      .pressed = {0x3A, 0x48, 0x54},
      .line = {0x2A, 0x32, 0x3A},
      .border = {0x66, 0x75, 0x82},
      .ahead = {0x6A, 0x7A, 0x88},
      .text = {0xE8, 0xEC, 0xEF},
      .quietText = {0x93, 0xA1, 0xAC},
      .accent = {0x45, 0xC4, 0xB0},
      .accentHover = {0x5A, 0xD3, 0xC0},
      .onAccent = {0x0B, 0x14, 0x12},
      .ghost = {0x56, 0xB4, 0xE9},
      .warning = {0xE6, 0x9F, 0x00},
      .onWarning = {0x14, 0x11, 0x0A},
      .alarm = {0xD5, 0x5E, 0x00},
      .banner = {0x2B, 0x21, 0x14},
  };
  return theme;
}

const Theme& lightTheme()
{
  static const Theme theme{
      .ground = {0xFF, 0xFF, 0xFF},
      .panel = {0xF1, 0xF4, 0xF6},
      .raised = {0xDF, 0xE6, 0xEA},
      .pressed = {0xAE, 0xBB, 0xC4},
      .line = {0xC9, 0xD3, 0xDA},
      .border = {0x7C, 0x8A, 0x95},
      .ahead = {0x76, 0x84, 0x8F},
      .text = {0x14, 0x1B, 0x21},
      .quietText = {0x4A, 0x56, 0x61},
      .accent = {0x08, 0x6B, 0x5D},
      .accentHover = {0x0A, 0x5C, 0x50},
      .onAccent = {0xFF, 0xFF, 0xFF},
      .ghost = {0x00, 0x62, 0x9B},
      .warning = {0x7A, 0x4C, 0x00},
      .onWarning = {0xFF, 0xFF, 0xFF},
      .alarm = {0xA9, 0x3A, 0x00},
      .banner = {0xFF, 0xF1, 0xD6},
  };
  return theme;
}

struct Shown {
  ColorScheme look = ColorScheme::dark;
  Theme theme;
  double textScale = 1.0;
  Lengths lengths;
};

Shown& shown()
{
  static Shown one{ColorScheme::dark, darkTheme(), 1.0, {}};
  return one;
}

// Color names between percent signs are substituted below.
constexpr auto sheet = R"(
QWidget { color: %text%; background: %panel%; }
QLabel { background: transparent; }
QLabel[quiet="true"] { color: %quietText%; }
QLabel[onPicture="true"] {
  color: %quietText%; background: %plate%; border-radius: 4px; padding: 2px 6px;
}
QLabel[error="true"] { color: %warning%; }
QLabel[badge="true"] {
  color: %onWarning%; background: %warning%; border-radius: 4px; padding: 1px 6px;
}
QFrame#line { background: %line%; border: none; }

QPushButton {
  background: %raised%; border: 1px solid %border%; border-radius: 5px; padding: 0 12px;
}
QPushButton:hover { border-color: %accent%; }
QPushButton:pressed { background: %line%; }
QPushButton:disabled { color: %quietText%; background: %panel%; border-color: %line%; }
QPushButton#startButton { background: %accent%; color: %onAccent%; border-color: %accent%; }
QPushButton#startButton:hover { background: %accentHover%; }
QPushButton#startButton:disabled { color: %quietText%; background: %panel%; border-color: %line%; }
QPushButton#stopButton { background: #C4161C; color: #FFFFFF; border: 2px solid #FFFFFF; }
QPushButton#stopButton:pressed { background: #8E0F14; }
QPushButton[page="true"] {
  background: transparent; border-color: transparent; color: %quietText%; padding: 0 8px;
}
QPushButton[page="true"]:hover { color: %text%; border-color: %line%; }
QPushButton[page="true"]:checked { background: %raised%; border-color: %raised%; color: %text%; }
QPushButton#holdButton:pressed, QPushButton#holdButton[held="true"] {
  background: %accent%; color: %onAccent%; border-color: %accent%;
}
QPushButton[primary="true"] {
  background: %accent%; color: %onAccent%; border-color: %accent%; padding: 0 16px;
}
QPushButton[primary="true"]:hover { background: %accentHover%; }
QPushButton[primary="true"]:disabled { color: %quietText%; background: %panel%; border-color: %line%; }
QPushButton#startPageButton {
  background: transparent; border-color: transparent; color: %accent%; padding: 0;
}
QPushButton[fold="true"] {
  background: transparent; border-color: transparent; color: %quietText%; padding: 0;
  text-align: left;
}
QPushButton[fold="true"]:hover { color: %text%; }
QPushButton[link="true"] {
  background: transparent; border-color: transparent; color: %accent%; padding: 0 8px;
  text-align: left;
}
QPushButton[link="true"]:hover { color: %text%; border-color: %line%; }
QPushButton[small="true"] { padding: 0 6px; }
QComboBox QAbstractItemView {
  background: %ground%; color: %text%; border: 1px solid %line%;
  selection-background-color: %raised%; selection-color: %text%; outline: none;
}
QScrollBar:vertical { background: transparent; width: 8px; margin: 0; }
QScrollBar::handle:vertical { background: %raised%; border-radius: 3px; min-height: 32px; }
QScrollBar::handle:vertical:hover { background: %pressed%; }
QScrollBar::add-line:vertical, QScrollBar::sub-line:vertical { height: 0; }
QScrollBar::add-page:vertical, QScrollBar::sub-page:vertical { background: transparent; }
QLineEdit:disabled { color: %quietText%; background: %panel%; }
QPlainTextEdit { background: %ground%; border: 1px solid %border%; border-radius: 4px; padding: 2px 4px; }
QPlainTextEdit[hint="true"] { color: %quietText%; }
QPlainTextEdit:focus { border: 2px solid %text%; padding: 1px 3px; }
QLineEdit {
  background: %ground%; border: 1px solid %border%; border-radius: 4px; padding: 0 8px;
  selection-background-color: %accent%; selection-color: %onAccent%;
}
QLineEdit[hint="true"] { color: %quietText%; }
QSpinBox {
  background: %ground%; border: 1px solid %border%; border-radius: 4px; padding: 0 8px;
}
QLineEdit:focus, QSpinBox:focus { border: 2px solid %text%; padding: 0 7px; }
QProgressBar { background: %ground%; border: none; border-radius: 3px; }
QProgressBar::chunk { background: %accent%; border-radius: 3px; }
QPushButton#keysButton {
  background: transparent; border-color: transparent; color: %quietText%; padding: 0;
}
QPushButton#keysButton:hover { color: %text%; border-color: %line%; }

QToolButton#viewButton {
  background: %plate%; border: 1px solid %border%; border-radius: 4px; padding: 2px 8px; color: %text%;
}
QToolButton#viewButton:hover { border-color: %accent%; }
QToolButton#viewButton::menu-indicator { image: none; }
QMenu { background: %panel%; border: 1px solid %line%; padding: 6px 0; }
QMenu::item { padding: 5px 24px 5px 32px; }
QMenu::item:selected { background: %raised%; }
QMenu::item:disabled { color: %quietText%; }
QMenu::separator { height: 1px; background: %line%; margin: 6px 0; }

QFrame#banner { background: %banner%; border: 1px solid %warning%; border-radius: 5px; }
QFrame#banner QLabel { color: %text%; }
QFrame#keys, QFrame#devices, QFrame#guide { background: %panel%; border: 1px solid %line%; border-radius: 6px; }
QTextBrowser { background: %panel%; border: none; selection-background-color: %accent%; selection-color: %onAccent%; }
QFrame#studyPlot { background: %ground%; border: 2px solid %line%; border-radius: 4px; }
QFrame#studyPlot[focused="true"] { border-color: %text%; }
QFrame#chartFrame { background: %ground%; border: 1px solid %line%; border-radius: 4px; }
QTableView, QListWidget {
  background: %ground%; border: 1px solid %line%; border-radius: 4px; outline: none;
  selection-background-color: %raised%; selection-color: %text%;
}
QTableView::item { border-bottom: 1px solid %line%; padding: 0 8px; }
QListWidget::item { border-bottom: 1px solid %line%; padding: 8px; }
QTableView::item:selected, QListWidget::item:selected { background: %raised%; color: %text%; }
QScrollArea#verdictScroll { border: 2px solid transparent; }
QTableView:focus, QListWidget:focus, QTextBrowser:focus, QScrollArea#verdictScroll:focus { border: 2px solid %text%; }
QHeaderView, QHeaderView::section { background: %ground%; color: %quietText%; border: none; }
QHeaderView::up-arrow, QHeaderView::down-arrow { image: none; width: 0; height: 0; }
QHeaderView::section { border-bottom: 1px solid %line%; padding: 6px 8px; }
QToolTip { color: %text%; background: %ground%; border: 1px solid %line%; padding: 4px; }

QFrame#notice { background: %banner%; border: none; border-bottom: 1px solid %line%; }
QFrame#buildingNote, QFrame#about, QFrame#settings { background: %panel%; border: 1px solid %accent%; border-radius: 6px; }
QPushButton#settingsButton, QPushButton#menuButton {
  background: transparent; border-color: transparent; color: %quietText%; padding: 0;
}
QPushButton#settingsButton:hover, QPushButton#menuButton:hover { color: %text%; border-color: %line%; }
)";

}  // namespace

QFont typeface(int size_px, QFont::Weight weight)
{
  QFont chosen;
  chosen.setFamilies({QStringLiteral("Inter"), QStringLiteral("DejaVu Sans")});
  chosen.setPixelSize(sized(size_px));
  chosen.setWeight(weight);
  return chosen;
}

const Theme& themeOf(ColorScheme look)
{
  return look == ColorScheme::light ? lightTheme() : darkTheme();
}

ColorScheme shownColorScheme() { return shown().look; }
const Theme& shownTheme() { return shown().theme; }

double textScale() { return shown().textScale; }

int sized(int size_px) { return qRound(size_px * textScale()); }

const Lengths& shownLengths() { return shown().lengths; }

void setTextScale(double scale)
{
  shown().textScale = scale;
  const Lengths usual;
  shown().lengths = {sized(usual.sidePanel), sized(usual.chartColumn), sized(usual.minChartColumn),
                     sized(usual.bar)};
}

void setShownColorScheme(ColorScheme look)
{
  shown().look = look;
  shown().theme = themeOf(look);
}

void paintPlate(QPainter& painter, const QRect& area)
{
  QColor plate = groundColor;
  plate.setAlpha(plateAlpha);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawRoundedRect(area, 6, 6);
}

QString windowStyle()
{
  QString filled = QString::fromLatin1(sheet);
  const Theme& theme = shownTheme();
  const std::pair<const char*, QColor> names[] = {
      {"%ground%", theme.ground},       {"%panel%", theme.panel},
      {"%raised%", theme.raised},       {"%pressed%", theme.pressed},
      {"%line%", theme.line},           {"%border%", theme.border},
      {"%text%", theme.text},           {"%quietText%", theme.quietText},
      {"%accent%", theme.accent},       {"%accentHover%", theme.accentHover},
      {"%onAccent%", theme.onAccent},   {"%warning%", theme.warning},
      {"%onWarning%", theme.onWarning}, {"%banner%", theme.banner},
  };
  for (const auto& [name, value] : names) filled.replace(QLatin1String(name), value.name());
  const QColor& ground = theme.ground;
  filled.replace(QLatin1String("%plate%"), QStringLiteral("rgba(%1, %2, %3, %4)")
                                               .arg(ground.red())
                                               .arg(ground.green())
                                               .arg(ground.blue())
                                               .arg(plateAlpha));
  return filled;
}

}  // namespace perilymph::gui
