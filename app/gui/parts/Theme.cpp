#include "Theme.h"

#include <QStringList>

namespace perilymph::gui {

namespace {

// Names of colors stand between percent signs and are filled in below.
constexpr auto sheet = R"(
QWidget { color: %text%; background: %panel%; }
QLabel { background: transparent; }
QLabel[quiet="true"] { color: %quietText%; }
QLabel[onPicture="true"] {
  color: %quietText%; background: rgba(18, 22, 26, 185); border-radius: 4px; padding: 2px 6px;
}
QLabel[trouble="true"] { color: %warning%; }
QLabel[badge="true"] {
  color: #14110A; background: %warning%; border-radius: 4px; padding: 1px 6px;
}
QFrame#line { background: %line%; border: none; }

QPushButton {
  background: %raised%; border: 1px solid %raised%; border-radius: 5px; padding: 0 12px;
}
QPushButton:hover { border-color: %accent%; }
QPushButton:pressed { background: %line%; }
QPushButton:disabled { color: #6C7A85; background: %line%; border-color: %line%; }
QPushButton#startButton { background: %accent%; color: #0B1412; border-color: %accent%; }
QPushButton#startButton:hover { background: #5AD3C0; }
QPushButton#startButton:disabled { color: #6C7A85; background: %line%; border-color: %line%; }
QPushButton[page="true"] {
  background: transparent; border-color: transparent; color: %quietText%; padding: 0;
}
QPushButton[page="true"]:hover { color: %text%; border-color: %line%; }
QPushButton[page="true"]:checked { background: %raised%; border-color: %raised%; color: %text%; }
QPushButton#holdButton:pressed, QPushButton#holdButton[held="true"] {
  background: %accent%; color: #0B1412; border-color: %accent%;
}
QPushButton[primary="true"] {
  background: %accent%; color: #0B1412; border-color: %accent%; padding: 0 16px;
}
QPushButton[primary="true"]:hover { background: #5AD3C0; }
QPushButton[primary="true"]:disabled { color: #6C7A85; background: %line%; border-color: %line%; }
QPushButton#startPageButton {
  background: transparent; border-color: transparent; color: %accent%; padding: 0;
}
QPushButton[fold="true"] {
  background: transparent; border-color: transparent; color: %quietText%; padding: 0;
  text-align: left;
}
QPushButton[fold="true"]:hover { color: %text%; }
QPushButton[small="true"] { padding: 0 6px; }
QPushButton[small="true"]:focus { border-color: %accent%; }
QComboBox QAbstractItemView {
  background: %ground%; color: %text%; border: 1px solid %line%;
  selection-background-color: %raised%; selection-color: %text%; outline: none;
}
QScrollBar:vertical { background: transparent; width: 8px; margin: 0; }
QScrollBar::handle:vertical { background: %raised%; border-radius: 3px; min-height: 32px; }
QScrollBar::handle:vertical:hover { background: #3A4854; }
QScrollBar::add-line:vertical, QScrollBar::sub-line:vertical { height: 0; }
QScrollBar::add-page:vertical, QScrollBar::sub-page:vertical { background: transparent; }
QLineEdit:disabled { color: %quietText%; background: %panel%; }
QLineEdit {
  background: %ground%; border: 1px solid %line%; border-radius: 4px; padding: 0 8px;
  selection-background-color: %accent%; selection-color: #0B1412;
}
QLineEdit:focus { border-color: %accent%; }
QSpinBox {
  background: %ground%; border: 1px solid %line%; border-radius: 4px; padding: 0 8px;
}
QSpinBox:focus { border-color: %accent%; }
QProgressBar { background: %ground%; border: none; border-radius: 3px; }
QProgressBar::chunk { background: %accent%; border-radius: 3px; }
QPushButton#keysButton { background: transparent; border-color: transparent; color: %quietText%; }
QPushButton#keysButton:hover { color: %text%; border-color: %line%; }

QFrame#banner { background: #2B2114; border: 1px solid %warning%; border-radius: 5px; }
QFrame#banner QLabel { color: %text%; }
QFrame#keys, QFrame#devices { background: %panel%; border: 1px solid %line%; border-radius: 6px; }
QFrame#chartFrame { background: %ground%; border: 1px solid %line%; border-radius: 4px; }
QToolTip { color: %text%; background: %ground%; border: 1px solid %line%; padding: 4px; }
)";

}  // namespace

QFont typeface(int size_px, QFont::Weight weight)
{
  QFont chosen;
  chosen.setFamilies({QStringLiteral("Inter"), QStringLiteral("DejaVu Sans")});
  chosen.setPixelSize(size_px);
  chosen.setWeight(weight);
  return chosen;
}

QString windowStyle()
{
  QString filled = QString::fromLatin1(sheet);
  const std::pair<const char*, QColor> names[] = {
      {"%ground%", groundColor}, {"%panel%", panelColor},     {"%raised%", raisedColor},
      {"%line%", lineColor},     {"%text%", textColor},       {"%quietText%", quietTextColor},
      {"%accent%", accentColor}, {"%warning%", warningColor},
  };
  for (const auto& [name, value] : names) filled.replace(QLatin1String(name), value.name());
  return filled;
}

}  // namespace perilymph::gui
