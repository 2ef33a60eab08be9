// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/Theme.h"

#include <QPainter>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

namespace perilymph::gui {

namespace {

Theme themeFrom(const figures::Palette& palette)
{
  return {
      .ground = colorOf(palette.ground),
      .panel = colorOf(palette.panel),
      .raised = colorOf(palette.raised),
      .pressed = colorOf(palette.pressed),
      .banner = colorOf(palette.banner),
      .line = colorOf(palette.line),
      .border = colorOf(palette.border),
      .ahead = colorOf(palette.ahead),
      .text = colorOf(palette.text),
      .quietText = colorOf(palette.quiet),
      .accent = colorOf(palette.accent),
      .accentHover = colorOf(palette.accentHover),
      .onAccent = colorOf(palette.onAccent),
      .ghost = colorOf(palette.blue),
      .pink = colorOf(palette.pink),
      .warning = colorOf(palette.warning),
      .onWarning = colorOf(palette.onWarning),
      .alarm = colorOf(palette.alarm),
      .stop = colorOf(palette.stop),
      .stopPressed = colorOf(palette.stopPressed),
      .onStop = colorOf(palette.onStop),
      .bone = colorOf(palette.bone),
      .lumen = colorOf(palette.lumen),
      .silicone = colorOf(palette.silicone),
      .platinum = colorOf(palette.platinum),
  };
}

struct Shown {
  ColorScheme look = ColorScheme::dark;
  double textScale = 1.0;
  Lengths lengths;
};

Shown& shown()
{
  static Shown one;
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
QLabel:disabled { color: %quietText%; }
QLabel[error="true"] { color: %warning%; }
QLabel[badge="true"] {
  color: %onWarning%; background: %warning%; border-radius: 4px; padding: 1px 6px;
}
QDialog#sendDialog { background: %panel%; }
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
QPushButton#stopButton { background: %stop%; color: %onStop%; border: 2px solid %onStop%; }
QPushButton#stopButton:pressed { background: %stopPressed%; }
QPushButton[page="true"] {
  background: transparent; border-color: transparent; color: %quietText%; padding: 0 8px;
}
QPushButton[page="true"]:hover { color: %text%; border-color: %line%; }
QPushButton[page="true"]:checked { background: %raised%; border-color: %raised%; color: %text%; }
QPushButton#holdButton:pressed, QPushButton#holdButton[held="true"] {
  background: %accent%; color: %onAccent%; border-color: %accent%;
}
QPushButton[primary="true"] {
  background: %accent%; color: %onAccent%; border-color: %accent%;
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
QScrollBar:horizontal { background: transparent; height: 8px; margin: 0; }
QScrollBar::handle:horizontal { background: %raised%; border-radius: 3px; min-width: 32px; }
QScrollBar::handle:horizontal:hover { background: %pressed%; }
QScrollBar::add-line:horizontal, QScrollBar::sub-line:horizontal { width: 0; }
QScrollBar::add-page:horizontal, QScrollBar::sub-page:horizontal { background: transparent; }
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
QFrame#buildingNote, QFrame#resultCard, QFrame#about, QFrame#settings { background: %panel%; border: 1px solid %accent%; border-radius: 6px; }
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

QColor colorOf(const figures::Ink& ink)
{
  QColor color(ink.rgb[0], ink.rgb[1], ink.rgb[2]);
  color.setAlphaF(float(ink.opacity));
  return color;
}

const Theme& themeOf(ColorScheme look)
{
  static const Theme dark = themeFrom(figures::paletteOf(ColorScheme::dark));
  static const Theme light = themeFrom(figures::paletteOf(ColorScheme::light));
  return look == ColorScheme::light ? light : dark;
}

ColorScheme shownColorScheme() { return shown().look; }
const Theme& shownTheme() { return themeOf(shown().look); }

double textScale() { return shown().textScale; }

int sized(int size_px) { return qRound(size_px * textScale()); }

const Lengths& shownLengths() { return shown().lengths; }

void setTextScale(double scale)
{
  shown().textScale = scale;
  const Lengths usual;
  // on a small screen the gaps between controls do not shrink as their texts do
  const int sidePanel = scale < 1.0 ? usual.sidePanel * 6 / 5 : usual.sidePanel;
  shown().lengths = {sized(sidePanel), sized(usual.chartColumn), sized(usual.minChartColumn),
                     sized(usual.bar)};
}

void setShownColorScheme(ColorScheme look) { shown().look = look; }

void paintPlate(QPainter& painter, const QRect& area)
{
  QColor plate = shownTheme().ground;
  plate.setAlpha(plateAlpha);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawRoundedRect(area, 6, 6);
}

namespace {

/// On a small screen margins shrink with the text.
QString withSmallerMargins(const QString& style)
{
  static const QRegularExpression length(QStringLiteral("\\b(\\d+)px"));
  QString scaled;
  decltype(style.size()) from = 0;
  for (auto each = length.globalMatch(style); each.hasNext();) {
    const QRegularExpressionMatch found = each.next();
    const int size_px = found.captured(1).toInt();
    scaled += style.mid(from, found.capturedStart() - from) +
              QStringLiteral("%1px").arg(size_px == 0 ? 0 : std::max(1, sized(size_px)));
    from = found.capturedEnd();
  }
  return scaled + style.mid(from);
}

}  // namespace

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
      {"%stop%", theme.stop},           {"%stopPressed%", theme.stopPressed},
      {"%onStop%", theme.onStop},
  };
  for (const auto& [name, value] : names) filled.replace(QLatin1String(name), value.name());
  const QColor& ground = theme.ground;
  filled.replace(QLatin1String("%plate%"), QStringLiteral("rgba(%1, %2, %3, %4)")
                                               .arg(ground.red())
                                               .arg(ground.green())
                                               .arg(ground.blue())
                                               .arg(plateAlpha));
  return textScale() < 1.0 ? withSmallerMargins(filled) : filled;
}

}  // namespace perilymph::gui
