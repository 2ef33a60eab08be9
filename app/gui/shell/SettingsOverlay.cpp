// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/SettingsOverlay.h"

#include <QButtonGroup>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/pages/insert/GraspControl.h"
#include "gui/report/ReportIssuer.h"
#include "gui/run/UserSettings.h"
#include "gui/setup/ScanFolders.h"
#include "gui/text/DataText.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/SheetScroll.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/foundation/StateFolder.h"

namespace perilymph::gui {

namespace {

constexpr int width_px = 420;

QLabel* label(const QString& text, int size_px, bool isQuiet, QWidget* parent)
{
  auto* made = new WrappedLabel(text, parent);
  made->setFont(typeface(size_px));
  made->setProperty("quiet", isQuiet);
  return made;
}

}  // namespace

QStringList colorSchemeText() { return {QStringLiteral("dark"), QStringLiteral("light")}; }

QStringList languageText()
{
  return {QStringLiteral("system"), QStringLiteral("en"), QStringLiteral("de")};
}

QStringList letterKeysText() { return {QStringLiteral("on"), QStringLiteral("off")}; }

QStringList textSizeText()
{
  return {QStringLiteral("90"), QStringLiteral("100"), QStringLiteral("115"), QStringLiteral("130"),
          QStringLiteral("150")};
}

SettingsOverlay::SettingsOverlay(QWidget* parent) : QFrame(parent), note_(label({}, 12, true, this))
{
  setObjectName(QStringLiteral("settings"));
  setFixedWidth(sized(width_px));
  auto* title = label(tr("Settings"), 15, false, this);
  title->setFont(typeface(15, QFont::DemiBold));
  auto* shut = new QPushButton(tr("Close"), this);
  shut->setObjectName(QStringLiteral("settingsCloseButton"));
  shut->setFont(typeface(13));
  shut->setFixedHeight(sized(28));
  shut->setFocusPolicy(Qt::TabFocus);
  connect(shut, &QPushButton::clicked, this, &SettingsOverlay::closeRequested);
  auto* head = new QHBoxLayout;
  head->addWidget(title, 1);
  head->addWidget(shut);

  auto* content = new QWidget(this);
  auto* column = new QVBoxLayout(content);
  column_ = column;
  column->setContentsMargins(3 * spacing, 2 * spacing, 2 * spacing, 2 * spacing);
  column->setSpacing(spacing);
  column->addLayout(head);
  addGroup(*column, tr("Colors"), QStringLiteral("look"), colorSchemeText(),
           {tr("dark"), tr("light")}, Effect::withNewWindow);
  addGroup(*column, tr("Language"), QStringLiteral("language"), languageText(),
           {tr("as the system"), QStringLiteral("English"), QStringLiteral("Deutsch")},
           Effect::withNewWindow);
  addTextSize(*column);
  addGroup(*column, tr("Hold the array (Space or button)"), QStringLiteral("hold"), holdText(),
           {tr("while pressed"), tr("press to hold, press again to release")}, Effect::atOnce);
  addGroup(*column, tr("Single-key shortcuts"), QStringLiteral("keys"), letterKeysText(),
           {tr("on"), tr("off")}, Effect::atOnce);
  column->addWidget(note_);
  addLine(*column, tr("Institution, for reports (optional)"), QStringLiteral("report/institution"));
  addLine(*column, tr("Operator, for reports (optional)"), QStringLiteral("report/operator"));
  addLogo(*column);
  addScans(*column);
  column->addWidget(label(
      tr("Log file: %1").arg(QString::fromStdString((stateFolder() / "perilymph.log").string())),
      12, true, this));
  column->addStretch();
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(1, 1, 1, 1);
  scroll_ = new SheetScroll(content, this);
  whole->addWidget(scroll_);
  setChangeable(true);
  hide();
}

void SettingsOverlay::addGroup(QVBoxLayout& column, const QString& title, const QString& key,
                               const QStringList& caption, const QStringList& names, Effect effect)
{
  auto* heading = label(title, 13, false, this);
  heading->setFont(typeface(13, QFont::DemiBold));
  column.addWidget(heading);
  auto* row = new QBoxLayout(QBoxLayout::LeftToRight);
  row->setSpacing(3 * spacing);
  int needed = 0;
  auto* group = new QButtonGroup(this);
  const QString now = UserSettings().word(key, caption);
  for (int i = 0; i < caption.size(); ++i) {
    auto* choice = new Choice(names[i], this);
    choice->setObjectName(key + QLatin1Char('-') + caption[i]);
    choice->setFocusPolicy(Qt::TabFocus);
    choice->setChecked(caption[i] == now);
    group->addButton(choice);
    choices_.push_back(choice);
    row->addWidget(choice);
    needed += choice->sizeHint().width() + 3 * spacing;
    connect(choice, &QAbstractButton::clicked, this,
            [this, key, effect, word = caption[i]] { set(key, word, effect); });
  }
  if (needed > sized(width_px) - 5 * spacing) {
    row->setDirection(QBoxLayout::TopToBottom);
    row->setSpacing(0);
  } else {
    row->addStretch();
  }
  column.addLayout(row);
}

void SettingsOverlay::addTextSize(QVBoxLayout& column)
{
  const QString key = QStringLiteral("textSize");
  auto* heading = label(tr("Text size"), 13, false, this);
  heading->setFont(typeface(13, QFont::DemiBold));
  auto* sizes = new Selector("textSize", tr("Text size"), this);
  for (const QString& percent : textSizeText()) sizes->addChoice(tr("%1 %").arg(percent), percent);
  sizes->show(UserSettings().word(key, textSizeText(), normalTextSize), {});
  connect(sizes, &Selector::chosen, this,
          [this, key](const QString& word) { set(key, word, Effect::withNewWindow); });
  choices_.push_back(sizes);
  auto* row = new QHBoxLayout;
  row->addWidget(heading, 1);
  row->addWidget(sizes);
  column.addLayout(row);
}

void SettingsOverlay::set(const QString& key, const QString& word, Effect effect)
{
  UserSettings settings;
  if (settings.value(key).toString() == word) return;
  settings.setValue(key, word);
  settings.sync();
  if (effect == Effect::withNewWindow) Q_EMIT chosen();
}

void SettingsOverlay::addLine(QVBoxLayout& column, const QString& title, const QString& key)
{
  auto* row = new QHBoxLayout;
  row->setSpacing(spacing);
  auto* caption = label(title, 13, false, this);
  auto* field = new QLineEdit(UserSettings().value(key).toString(), this);
  field->setObjectName(key);
  field->setAccessibleName(title);
  field->setMaxLength(80);
  field->setFont(typeface(13));
  field->setFixedHeight(sized(26));
  caption->setBuddy(field);
  connect(field, &QLineEdit::editingFinished, this,
          [field, key] { UserSettings().setValue(key, field->text().trimmed()); });
  row->addWidget(caption, 1);
  row->addWidget(field, 1);
  column.addLayout(row);
}

void SettingsOverlay::addLogo(QVBoxLayout& column)
{
  const QString key = QStringLiteral("report/logo");
  auto* row = new QHBoxLayout;
  row->setSpacing(spacing);
  auto* choose = new QPushButton(this);
  choose->setObjectName(key);
  choose->setFont(typeface(13));
  choose->setFixedHeight(sized(26));
  choose->setFocusPolicy(Qt::TabFocus);
  auto* error = label({}, 12, true, this);
  error->setProperty("error", true);
  error->hide();
  const auto show = [choose, key] {
    const QString file = UserSettings().value(key).toString();
    choose->setText(file.isEmpty() ? tr("Choose…") : tr("Remove"));
    choose->setToolTip(file);
  };
  show();
  connect(choose, &QPushButton::clicked, this, [this, show, error, key] {
    const bool isSet = !UserSettings().value(key).toString().isEmpty();
    const QString file = isSet ? QString()
                               : QFileDialog::getOpenFileName(this, tr("Logo for reports"), {},
                                                              tr("Pictures (*.png *.jpg *.jpeg)"));
    const auto logo = file.isEmpty() ? Result<QImage>(QImage()) : readLogo(file);
    error->setText(logo ? QString() : dataText(logo.error().message));
    error->setVisible(!logo);
    if (logo && (isSet || !file.isEmpty())) UserSettings().setValue(key, file);
    show();
  });
  row->addWidget(label(tr("Logo, for reports"), 13, false, this), 1);
  row->addWidget(choose);
  column.addLayout(row);
  column.addWidget(error);
}

void SettingsOverlay::addScans(QVBoxLayout& column)
{
  auto* row = new QHBoxLayout;
  row->setSpacing(spacing);
  auto* clear = new QPushButton(tr("Clear"), this);
  clear->setObjectName(QStringLiteral("clearScansButton"));
  clear->setFont(typeface(13));
  clear->setFixedHeight(sized(26));
  clear->setFocusPolicy(Qt::TabFocus);
  clear->setToolTip(tr(
      "Removes the list of where CTs were opened, which the history of patients uses, too. No CT "
      "and no measure is deleted."));
  auto* answer = label({}, 12, true, this);
  answer->setObjectName(QStringLiteral("clearScansStatus"));
  answer->hide();
  connect(clear, &QPushButton::clicked, this, [answer] {
    answer->setText(clearScans() ? tr("It is no longer known where CTs were opened.")
                                 : tr("The list cannot be removed. Check the permissions of the "
                                      "folder of the log file."));
    answer->show();
  });
  row->addWidget(label(tr("Recent CTs"), 13, false, this), 1);
  row->addWidget(clear);
  column.addLayout(row);
  column.addWidget(answer);
}

void SettingsOverlay::append(QWidget* section)
{
  column_->insertWidget(column_->count() - 2, section);  // above the log file
}

void SettingsOverlay::scrollTo(const QWidget& section)
{
  scroll_->verticalScrollBar()->setValue(section.y());
}

void SettingsOverlay::setChangeable(bool isChangeable)
{
  for (QWidget* choice : choices_) choice->setEnabled(isChangeable);
  note_->setText(isChangeable ? tr("Changes reload the window.")
                              : tr("Settings are locked during an insertion. Press Reset first."));
}

}  // namespace perilymph::gui
