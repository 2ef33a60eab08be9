#include "KeyList.h"

#include <QGridLayout>
#include <QLabel>
#include <QVariant>

#include "Theme.h"

namespace perilymph::gui {

KeyList::KeyList(QWidget* parent) : QFrame(parent)
{
  setObjectName(QStringLiteral("keys"));
  const struct {
    QString keys, meaning;  // no keys: a heading
  } rows[] = {
      {{}, tr("Insertion")},
      {tr("Space"), tr("start or pause; hold the array with mouse and keyboard")},
      {tr("Wheel, Up, Down"), tr("advance or withdraw the array while it is held")},
      {tr("Backspace"), tr("withdraw")},
      {tr("Ctrl+R"), tr("reset: a fresh insertion and recording")},
      {tr("S"), tr("pull the stylet")},
      {tr("Esc"), tr("let go of the array")},
      {{}, tr("Picture")},
      {tr("1  2  3  4"), tr("surgeon’s view, down the opening, overview, section")},
      {tr("F"), tr("follow the tip")},
      {tr("Drag; A D W X"), tr("turn the model")},
      {tr("Shift+drag; Shift+arrows"), tr("move the model")},
      {tr("Wheel, Ctrl+wheel, + −"), tr("magnify")},
      {{}, tr("Window")},
      {tr("Alt+Home"), tr("begin anew: the first screen")},
      {tr("Alt+1 to Alt+4"), tr("insert, compare, validate, sessions")},
      {tr("H"), tr("devices: which there are, and how the hand is doing")},
      {tr("?"), tr("this list")},
  };

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(3 * spacing, 2 * spacing, 3 * spacing, 2 * spacing);
  grid->setHorizontalSpacing(3 * spacing);
  grid->setVerticalSpacing(6);
  int line = 0;
  for (const auto& row : rows) {
    auto* meaning = new QLabel(row.meaning, this);
    if (row.keys.isEmpty()) {
      meaning->setFont(typeface(13, QFont::DemiBold));
      grid->addWidget(meaning, line++, 0, 1, 2);
      continue;
    }
    auto* keys = new QLabel(row.keys, this);
    keys->setFont(typeface(13, QFont::Medium));
    meaning->setFont(typeface(13));
    meaning->setProperty("quiet", true);
    grid->addWidget(keys, line, 0);
    grid->addWidget(meaning, line++, 1);
  }
  hide();
}

}  // namespace perilymph::gui
