// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/devices/DevicePage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/text/DataText.h"
#include "gui/text/DeviceRate.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int pageWidth_px = 580;

QString milliseconds(double time) { return numberText(time * 1e3, 2); }

QString abilityText(const device::FoundDevice& found)
{
  if (!found.known) return QString::fromStdString(found.kind);
  const device::DeviceTraits& traits = found.known->traits;
  const QString force = traits.rendersForce
                            ? DevicePage::tr("force up to %1 N").arg(numberText(traits.maxForce, 1))
                            : DevicePage::tr("no force");
  return DevicePage::tr("%1 · %2 · report interval %3 ms")
      .arg(QString::fromStdString(found.kind), force, numberText(traits.nominalPeriod * 1e3, 1));
}

}  // namespace

DevicePage::DevicePage(QWidget* parent)
    : QFrame(parent), inUse_(new QLabel(this)), live_(new QLabel(this))
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

QLabel* DevicePage::addText(QVBoxLayout& column, const QString& text, bool isQuiet)
{
  auto* label = new QLabel(text, list_);
  label->setFont(typeface(isQuiet ? 12 : 13, isQuiet ? QFont::Normal : QFont::Medium));
  label->setProperty("quiet", isQuiet);
  label->setWordWrap(true);
  // a udev rule can be selected and copied
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column.addWidget(label);
  return label;
}

void DevicePage::refresh()
{
  delete list_;
  list_ = new QWidget(this);
  auto* column = new QVBoxLayout(list_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  const device::DeviceSurvey survey = device::surveyDevices(device::systemRoots());
  if (survey.devices.empty()) addText(*column, tr("No HID device is connected."), false);
  for (const device::FoundDevice& found : survey.devices) addDevice(found);
  for (const std::string& error : survey.errors)
    addText(*column, QString::fromStdString(error), true);
  addText(*column, tr("Available without hardware: scripted insertion, and mouse and keyboard."),
          true);
  column_->addWidget(list_);
  list_->show();  // the page may be visible already
  fit();
}

void DevicePage::fit()
{
  column_->activate();
  const QPoint middle = geometry().center();
  // Text is wrapped: the height depends on the width.
  resize(width(), column_->totalHeightForWidth(width()));
  if (isVisible()) move(x(), std::max(0, middle.y() - height() / 2));
}

void DevicePage::addDevice(const device::FoundDevice& found)
{
  auto& column = static_cast<QVBoxLayout&>(*list_->layout());
  const device::HidNode& node = found.node;
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(QString::fromStdString(found.name()), list_);
  name->setFont(typeface(13, QFont::Medium));
  row->addWidget(name, 1);
  if (found.isUsable()) {
    auto* use = new QPushButton(tr("Use as input"), list_);
    use->setObjectName(QStringLiteral("use-") +
                       QString::fromStdString(node.path.filename().string()));
    use->setFont(typeface(12));
    use->setFixedHeight(sized(24));
    use->setFocusPolicy(Qt::NoFocus);
    use->setEnabled(isChangeable_);
    use->setProperty("chooses", true);
    connect(use, &QPushButton::clicked, this, [this, found] { Q_EMIT deviceChosen(found); });
    row->addWidget(use);
  }
  column.addLayout(row);
  addText(column,
          tr("%1 · %2 · %3")
              .arg(QString::fromStdString(node.path.string()),
                   QString::fromStdString(device::identityText(node.identity)), abilityText(found)),
          true);
  if (found.known)
    addText(column,
            tr("Profile %1, confidence %2. %3")
                .arg(QString::fromStdString(found.known->file),
                     QString::fromStdString(found.known->confidence),
                     QString::fromStdString(found.known->caution))
                .trimmed(),
            true);
  if (!found.isUsable()) addText(column, QString::fromStdString(found.obstacle), true);
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
