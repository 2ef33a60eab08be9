// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/devices/DevicePage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/run/Background.h"
#include "gui/run/InputChoice.h"
#include "gui/text/DataText.h"
#include "gui/text/DeviceRate.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/SheetScroll.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int pageWidth_px = 580;

QString milliseconds(double time) { return numberText(time * 1e3, 2); }

QString abilityText(const QString& kind, const device::DeviceTraits& traits)
{
  const QString force = traits.rendersForce
                            ? DevicePage::tr("force up to %1 N").arg(numberText(traits.maxForce, 1))
                            : DevicePage::tr("no force");
  return DevicePage::tr("%1 · %2 · report interval %3 ms")
      .arg(kind, force, numberText(traits.nominalPeriod * 1e3, 1));
}

QString abilityText(const device::FoundDevice& found)
{
  const QString kind = QString::fromStdString(found.kind);
  return found.known ? abilityText(kind, found.known->traits) : kind;
}

}  // namespace

DevicePage::DevicePage(QWidget* parent)
    : QFrame(parent),
      inUse_(new QLabel(this)),
      live_(new QLabel(this)),
      search_(new Background(this))
{
  setObjectName(QStringLiteral("devices"));
  setFixedWidth(sized(pageWidth_px));

  auto* title = new QLabel(tr("Devices"), this);
  title->setFont(typeface(15, QFont::DemiBold));
  const auto button = [this](const QString& text, const char* name) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(QLatin1String(name));
    made->setFont(typeface(13));
    made->setFixedHeight(sized(28));
    made->setFocusPolicy(Qt::NoFocus);
    return made;
  };
  QPushButton* again = button(tr("Refresh"), "devicesRefreshButton");
  QPushButton* shut = button(tr("Close (H)"), "devicesCloseButton");
  connect(again, &QPushButton::clicked, this, &DevicePage::refresh);
  connect(shut, &QPushButton::clicked, this, &DevicePage::closeRequested);

  auto* head = new QHBoxLayout;
  head->setSpacing(spacing);
  head->addWidget(title, 1);
  head->addWidget(again);
  head->addWidget(shut);

  column_ = new QVBoxLayout(this);
  column_->setContentsMargins(3 * spacing, 2 * spacing, 3 * spacing, 2 * spacing);
  column_->setSpacing(spacing);
  column_->addLayout(head);
  inUse_->setFont(typeface(13, QFont::Medium));
  inUse_->setObjectName(QStringLiteral("deviceInUse"));
  live_->setFont(typeface(13));
  live_->setProperty("quiet", true);
  live_->setWordWrap(true);
  live_->setObjectName(QStringLiteral("deviceFigures"));
  column_->addWidget(inUse_);
  column_->addWidget(live_);
  hide();
}

QLabel* DevicePage::addText(const QString& text, bool isQuiet)
{
  auto* label = new QLabel(text, list_);
  label->setFont(typeface(isQuiet ? 12 : 13, isQuiet ? QFont::Normal : QFont::Medium));
  label->setProperty("quiet", isQuiet);
  label->setWordWrap(true);
  // a udev rule can be selected and copied
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  list_->layout()->addWidget(label);
  return label;
}

void DevicePage::refresh()
{
  // Loading plug-ins beside an insertion would take time from it.
  if (isChangeable_)
    search_->run(
        "The plug-ins",
        [](const std::stop_token&) -> Result<std::vector<device::FoundPlugin>> {
          return device::surveyPlugins();
        },
        [this](Result<std::vector<device::FoundPlugin>> found) {
          if (found) plugins_ = *std::move(found);
          if (isVisible()) fillList();
        });
  fillList();
}

void DevicePage::fillList()
{
  delete scroll_;
  list_ = new QWidget;
  auto* column = new QVBoxLayout(list_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  scroll_ = new SheetScroll(list_, this);
  const device::DeviceSurvey survey = device::surveyDevices(device::systemRoots());
  if (survey.devices.empty()) addText(tr("No HID device is connected."), false);
  for (const device::FoundDevice& found : survey.devices) addDevice(found, survey);
  for (const std::string& error : survey.errors) addText(QString::fromStdString(error), true);
  addPlugins();
  addText(tr("Available without hardware: scripted insertion, and mouse and keyboard."), true);
  column_->addWidget(scroll_, 1);
  scroll_->show();  // the page may be visible already
  fit();
}

void DevicePage::addPlugins()
{
  for (const device::FoundPlugin& plugin : plugins_) addPlugin(plugin);
  if (search_->isBusy())
    addText(tr("Loading the installed plug-ins…"), true);
  else if (plugins_.empty())
    addText(tr("No plug-in is installed."), false);
  addText(tr("Plug-ins are installed in %1, for all users in %2.")
              .arg(QString::fromStdString(device::pluginFolders().front().string()),
                   QString::fromStdString(device::pluginFolders().back().string())),
          true);
}

void DevicePage::fitAbove(int bottom)
{
  bottom_ = bottom;
  fit();
}

void DevicePage::fit()
{
  const QPoint middle = geometry().center();
  const int maximum = bottom_ > 0 ? bottom_ : parentWidget()->height();
  // Text is wrapped: the height depends on the width.
  int content = 0;
  if (scroll_ != nullptr) {
    const QMargins margins = column_->contentsMargins();
    content = list_->layout()->totalHeightForWidth(width() - margins.left() - margins.right());
    scroll_->setFixedHeight(content);
  }
  column_->activate();
  const int whole = column_->totalHeightForWidth(width());
  if (scroll_ != nullptr && whole > maximum)
    scroll_->setFixedHeight(
        std::max(scroll_->minimumSizeHint().height(), content - whole + maximum));
  resize(width(), std::min(whole, maximum));
  if (isVisible())
    move(x(), std::clamp(middle.y() - height() / 2, 0, std::max(0, maximum - height())));
}

/// The title of a device that cannot be chosen.
void DevicePage::addTitle(const QString& title)
{
  auto& column = static_cast<QVBoxLayout&>(*list_->layout());
  column.addSpacing(spacing);
  addText(title, false);
}

/// The title of a device, with a button that chooses it.
QPushButton* DevicePage::addRow(const QString& title, bool isRemembered)
{
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(isRemembered ? tr("%1 (chosen last)").arg(title) : title, list_);
  name->setFont(typeface(13, QFont::Medium));
  row->addWidget(name, 1);
  auto* use = new QPushButton(tr("Use as input"), list_);
  use->setFont(typeface(12));
  use->setFixedHeight(sized(24));
  use->setFocusPolicy(Qt::NoFocus);
  use->setEnabled(isChangeable_);
  use->setProperty("chooses", true);
  row->addWidget(use);
  auto& column = static_cast<QVBoxLayout&>(*list_->layout());
  column.addSpacing(spacing);
  column.addLayout(row);
  return use;
}

void DevicePage::addDevice(const device::FoundDevice& found, const device::DeviceSurvey& survey)
{
  const device::HidNode& node = found.node;
  const QString title = QString::fromStdString(found.name());
  if (found.isUsable()) {
    QPushButton* use = addRow(title, isRememberedInput(found, survey));
    use->setObjectName(QStringLiteral("use-") +
                       QString::fromStdString(node.path.filename().string()));
    connect(use, &QPushButton::clicked, this, [this, found] { Q_EMIT deviceChosen(found); });
  } else {
    addTitle(title);
  }
  QString where = QString::fromStdString(node.path.string());
  if (!node.place.empty()) where = tr("%1 at %2").arg(where, QString::fromStdString(node.place));
  addText(tr("%1 · %2 · %3")
              .arg(where, QString::fromStdString(device::identityText(node.identity)),
                   abilityText(found)),
          true);
  if (found.known)
    addText(tr("Profile %1, confidence %2. %3")
                .arg(QString::fromStdString(found.known->file),
                     QString::fromStdString(found.known->confidence),
                     QString::fromStdString(found.known->caution))
                .trimmed(),
            true);
  if (!found.isUsable()) addText(QString::fromStdString(found.obstacle), true);
}

void DevicePage::addPlugin(const device::FoundPlugin& plugin)
{
  const QString title = QString::fromStdString(plugin.name);
  if (!plugin.isUsable()) {
    addTitle(title);
    addText(dataText(plugin.obstacle), true);
    return;
  }
  QPushButton* use = addRow(title, isRememberedInput(plugin.file));
  use->setObjectName(QStringLiteral("use-") + QString::fromStdString(plugin.file.stem().string()));
  connect(use, &QPushButton::clicked, this, [this, plugin] { Q_EMIT pluginChosen(plugin); });
  addText(abilityText(tr("Plug-in"), plugin.traits), true);
  addText(QString::fromStdString(plugin.file.string()), true);
}

void DevicePage::setChangeable(bool isChangeable)
{
  if (isChangeable == isChangeable_) return;
  isChangeable_ = isChangeable;
  for (QPushButton* button : findChildren<QPushButton*>())
    if (button->property("chooses").toBool()) button->setEnabled(isChangeable);
}

void DevicePage::showInUse(const QString& name, const std::optional<device::DeviceHealth>& health,
                           const haptics::Snapshot& now, const QString& coupling)
{
  inUse_->setText(tr("Input: %1").arg(dataText(name.toStdString())));
  QStringList lines;
  if (now.measuredRate > 0.0)
    lines << tr("Loop: %1 samples/s, %2 late, %3 overruns, 99 % below %4 ms.")
                 .arg(numberText(now.measuredRate, 0))
                 .arg(now.lateTicks)
                 .arg(now.overruns)
                 .arg(milliseconds(now.tickTimeP99));
  if (health) {
    const device::ReadingFigures& reading = health->reading;
    lines << tr("Reports: %1/s; interval median %2 ms, 99 % below %3 ms, maximum %4 ms.")
                 .arg(numberText(reading.rate, 0), milliseconds(reading.intervalMedian),
                      milliseconds(reading.intervalP99), milliseconds(reading.intervalMax));
    lines << tr("%1 lost, %2 repeated, %3 outdated, %4 invalid.")
                 .arg(reading.lost)
                 .arg(reading.duplicates)
                 .arg(reading.old)
                 .arg(reading.foreign);
    if (health->writing.accepted > 0)
      lines << tr("Force output takes %1 ms, 99 % below %2 ms; %3.")
                   .arg(milliseconds(health->writing.timeMedian),
                        milliseconds(health->writing.timeP99), roundTripText(*health));
    if (!health->guardObstacle.empty()) lines << QString::fromStdString(health->guardObstacle);
    if (!health->error.empty()) lines << QString::fromStdString(health->error);
  } else {
    lines << tr("No hardware needed; no force feedback.");
  }
  if (!coupling.isEmpty()) lines << coupling;
  const QString caption = lines.join(QLatin1Char('\n'));
  if (caption == live_->text()) return;
  live_->setText(caption);
  live_->setVisible(!caption.isEmpty());
  fit();
}

}  // namespace perilymph::gui
