// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/TopBar.h"

#include <QFontMetrics>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QVariant>
#include <algorithm>

#include "gui/pages/Page.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/setup/SetupTitle.h"
#include "gui/shell/StopTriggers.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/ElidedLabel.h"
#include "gui/widgets/Icon.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int pillHeight_px = 26;

constexpr int gear_px = 18, pageIcon_px = 16;
/// Between icon and name, which Qt's buttons define, and between buttons with icons.
constexpr int iconGap_px = 4, iconSpacing_px = 2;
/// A device's state as text, of usual length.
constexpr int deviceRoom_px = 110;

/// Width of a page's button without icon; the style sheet, which defines the size hint, is applied later.
int widthOf(const QString& name, const QPushButton& button)
{
  return std::max(44, QFontMetrics(button.font()).horizontalAdvance(name) + 2 * spacing + 2);
}

QColor colorOf(DeviceState light)
{
  switch (light) {
    case DeviceState::steady:
      return shownTheme().accent;
    case DeviceState::warning:
      return shownTheme().warning;
    case DeviceState::alarm:
      return shownTheme().alarm;
    case DeviceState::off:
      break;
  }
  return shownTheme().quietText;
}

}  // namespace

DeviceLight::DeviceLight(QWidget* parent) : QWidget(parent)
{
  setFont(typeface(13));
  setObjectName(QStringLiteral("deviceLight"));
  setAttribute(Qt::WA_NoSystemBackground);
}

void DeviceLight::show(DeviceState light, const QString& caption)
{
  if (light == light_ && caption == text_) return;
  light_ = light;
  text_ = caption;
  setAccessibleName(caption);
  updateGeometry();
  update();
}

QSize DeviceLight::sizeHint() const
{
  return {QFontMetrics(font()).horizontalAdvance(text_) + 38, sized(pillHeight_px)};
}

void DeviceLight::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF pill(0.5, (height() - sized(pillHeight_px)) / 2.0 + 0.5, width() - 1.0,
                    sized(pillHeight_px) - 1.0);
  painter.setPen(light_ == DeviceState::off ? QPen(shownTheme().line) : QPen(Qt::NoPen));
  painter.setBrush(light_ == DeviceState::off ? shownTheme().panel : shownTheme().raised);
  painter.drawRoundedRect(pill, sized(pillHeight_px) / 2.0, sized(pillHeight_px) / 2.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colorOf(light_));
  painter.drawEllipse(QPointF(15.0, height() / 2.0), 4.0, 4.0);
  painter.setPen(shownTheme().text);
  painter.drawText(rect().adjusted(26, 0, -8, 0), Qt::AlignVCenter | Qt::AlignLeft, text_);
}

void StopButton::mousePressEvent(QMouseEvent* event)
{
  Q_EMIT stopRequested();
  QPushButton::mousePressEvent(event);
}

TopBar::TopBar(QWidget* parent)
    : QWidget(parent),
      left_(new QHBoxLayout),
      tabs_(new QHBoxLayout),
      patient_(new ElidedLabel(this)),
      modified_(new QLabel(tr("MODIFIED"), this)),
      stop_(new StopButton(tr("STOP"), this)),
      device_(new DeviceLight(this)),
      menu_(new QPushButton(QStringLiteral("☰"), this))
{
  setFixedHeight(shownLengths().bar);
  patient_->setFont(typeface(13, QFont::Medium));
  patient_->setAlignment(Qt::AlignCenter);
  patient_->setObjectName(QStringLiteral("patientLabel"));

  modified_->setObjectName(QStringLiteral("modifiedLabel"));
  modified_->setProperty("badge", true);
  modified_->setFont(typeface(11, QFont::DemiBold));
  modified_->setFixedHeight(sized(20));
  modified_->hide();
  addStop();

  auto* keys = new QPushButton(QStringLiteral("?"), this);
  keys->setObjectName(QStringLiteral("keysButton"));
  keys->setFont(typeface(15));
  keys->setFixedSize(sized(32), sized(28));
  keys->setFocusPolicy(Qt::TabFocus);
  keys->setToolTip(tr("Keyboard and mouse (F1)"));
  keys->setAccessibleName(tr("Keyboard and mouse"));
  connect(keys, &QPushButton::clicked, this, &TopBar::keysRequested);
  auto* settings = new QPushButton(this);
  settings->setIcon(iconOf(Icon::settings, gear_px, devicePixelRatioF()));
  settings->setIconSize(QSize(gear_px, gear_px));
  settings->setObjectName(QStringLiteral("settingsButton"));
  settings->setFont(typeface(15));
  settings->setFixedSize(sized(32), sized(28));
  settings->setFocusPolicy(Qt::TabFocus);
  settings->setToolTip(tr("Settings (Ctrl+,)"));
  settings->setAccessibleName(tr("Settings"));
  connect(settings, &QPushButton::clicked, this, &TopBar::settingsRequested);
  menu_->setObjectName(QStringLiteral("menuButton"));
  menu_->setFont(typeface(15));
  menu_->setFixedSize(sized(32), sized(28));
  menu_->setFocusPolicy(Qt::TabFocus);
  menu_->setToolTip(tr("Menu"));
  menu_->setAccessibleName(tr("Menu"));

  left_->setSpacing(3 * spacing);
  tabs_->setSpacing(spacing);
  left_->addLayout(tabs_);
  left_->addStretch();
  auto* right = new QHBoxLayout;
  right->setSpacing(2 * spacing);
  right->addStretch();
  right->addWidget(stop_);
  right->addWidget(device_);
  right->addWidget(keys);
  right->addWidget(settings);
  right->addWidget(menu_);

  // Both sides have equal widths, so that the patient is in the center of the window.
  auto* columns = new QGridLayout(this);
  columns->setContentsMargins(2 * spacing, 0, 2 * spacing, 0);
  columns->addLayout(left_, 0, 0);
  middle_ = new QHBoxLayout;
  middle_->setSpacing(spacing);
  middle_->addWidget(patient_);
  middle_->addWidget(modified_);
  columns->addLayout(middle_, 0, 1);
  showNobody();
  columns->addLayout(right, 0, 2);
  columns->setColumnStretch(0, 1);
  columns->setColumnStretch(2, 1);
}

void TopBar::moveToTabEnd()
{
  std::vector<QWidget*> stops{stop_, home_};
  for (const char* name : {"keysButton", "settingsButton", "menuButton"})
    stops.push_back(findChild<QPushButton*>(QLatin1String(name)));
  for (const auto& [page, button] : pages_) stops.push_back(button);
  QWidget* last = window()->previousInFocusChain();
  while (last != window() && (isAncestorOf(last) || last->focusPolicy() == Qt::NoFocus))
    last = last->previousInFocusChain();
  for (QWidget* stop : stops) {
    setTabOrder(last, stop);
    last = stop;
  }
}

void TopBar::setMenu(QMenu* menu)
{
  connect(menu_, &QPushButton::clicked, menu, [this, menu] {
    const int right = width() - menu->sizeHint().width();
    menu->popup(mapToGlobal(QPoint(right - spacing, height())));
  });
}

void TopBar::addStop()
{
  stop_->setObjectName(QStringLiteral("stopButton"));
  stop_->setFont(typeface(17, QFont::Bold));
  stop_->setFixedSize(sized(128), shownLengths().bar - 6);
  // A click leaves the focus where it is: Space remains the key of the insertion.
  stop_->setFocusPolicy(Qt::TabFocus);
  stop_->setToolTip(tr("Remove the force of the device at once (Esc)"));
  stop_->setAccessibleName(tr("Stop: remove the force of the device"));
  stop_->hide();
  connect(stop_, &StopButton::stopRequested, this, &TopBar::stopRequested);
  connect(stop_, &QPushButton::pressed, this, &TopBar::stopRequested);  // by a key
}

QPushButton* TopBar::pageButton(const Page& page, const QString& text)
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(page.objectName() + QLatin1String("Button"));
  button->setProperty(leavesInsertion, !page.showsInsertion());
  button->setFocusPolicy(Qt::TabFocus);
  connect(button, &QPushButton::clicked, this, [this, &page] { Q_EMIT pageChosen(page.id()); });
  return button;
}

void TopBar::setPages(const std::vector<Page*>& pages)
{
  for (const Page* page : pages) {
    if (page != pages.front()) {
      addPage(*page);
      continue;
    }
    start_ = page;
    home_ = pageButton(*page, tr("Perilymph"));
    home_->setIconSize(QSize(sized(pageIcon_px), sized(pageIcon_px)));
    home_->setFont(typeface(15, QFont::DemiBold));
    home_->setToolTip(tr("%1 (Alt+Home)").arg(page->name()));
    left_->insertWidget(0, home_);
  }
}

void TopBar::addPage(const Page& page)
{
  QPushButton* button = pageButton(page, page.name());
  button->setProperty("page", true);
  button->setFont(typeface(13, QFont::Medium));
  button->setFixedHeight(sized(28));
  button->setMinimumWidth(widthOf(page.name(), *button));
  button->setIconSize(QSize(sized(pageIcon_px), sized(pageIcon_px)));
  button->setCheckable(true);
  tabs_->addWidget(button);
  pages_.emplace_back(&page, button);
}

void TopBar::resizeEvent(QResizeEvent*) { fit(); }

void TopBar::fit()
{
  if (home_ == nullptr) return;
  // Icons help to find a page, but cut neither names nor patient: the Stop button is counted, too,
  // so that pages stay where they are when it appears.
  const int spaces = 3 * sized(32) + 21 * spacing;
  int names = 0;
  for (const auto& [page, button] : pages_) names += widthOf(page->name(), *button);
  const int icons = int(pages_.size()) * (sized(pageIcon_px) + iconGap_px + iconSpacing_px);
  int subject = QFontMetrics(patient_->font()).horizontalAdvance(subject_);
  if (!modified_->isHidden()) subject += modified_->sizeHint().width() + spacing;
  const int home = widthOf(tr("Perilymph"), *home_);
  const int named = home + names + int(pages_.size()) * spacing + subject +
                    device_->sizeHint().width() + spaces + (stop_->isHidden() ? 0 : stop_->width());
  const bool isRoomForIcons =
      home + names + icons + subject + stop_->width() + spaces + sized(deviceRoom_px) <= width();
  const PageFace face = isRoomForIcons     ? PageFace::iconAndName
                        : named <= width() ? PageFace::name
                                           : PageFace::icon;
  if (face != face_) {
    face_ = face;
    showPages();
  }
  showPatient();
}

void TopBar::showPages()
{
  const bool haveIcons = face_ != PageFace::name, haveNames = face_ != PageFace::icon;
  const int icon = sized(pageIcon_px) + iconGap_px;
  tabs_->setSpacing(face_ == PageFace::iconAndName ? iconSpacing_px : spacing);
  const auto show = [&](const Page& page, const QString& name, QPushButton& button, bool hasIcon) {
    button.setIcon(hasIcon ? iconOf(page.icon(), sized(pageIcon_px), devicePixelRatioF())
                           : QIcon());
    button.setText(haveNames ? name : QString());
    button.setAccessibleName(name);
  };
  for (const auto& [page, button] : pages_) {
    show(*page, page->name(), *button, haveIcons);
    button->setToolTip(haveNames ? QString() : page->name());
    button->setMinimumWidth(haveNames ? widthOf(page->name(), *button) + (haveIcons ? icon : 0)
                                      : sized(32));
  }
  show(*start_, tr("Perilymph"), *home_, !haveNames);
}

void TopBar::showPatient()
{
  const bool isShort = face_ == PageFace::icon;
  patient_->setText(isShort ? shortSubject_ : subject_);
  patient_->setToolTip(isShort ? subject_ : QString());
}

void TopBar::setPage(const Page& page)
{
  for (const auto& [own, button] : pages_) button->setChecked(own == &page);
}

void TopBar::showSubject(const session::Scenario& scenario, const QString& changed)
{
  subject_ = subjectText(scenario);
  shortSubject_ = shortSubjectText(scenario);
  middle_->setContentsMargins(3 * spacing, 0, 3 * spacing, 0);
  modified_->setVisible(!changed.isEmpty());
  modified_->setToolTip(tr("Differs from the preset: %1.").arg(changed));
  fit();
}

void TopBar::showNobody()
{
  subject_.clear();
  shortSubject_.clear();
  middle_->setContentsMargins(spacing, 0, spacing, 0);  // the pages need the room
  modified_->hide();
  fit();
}

void TopBar::showInsertion(const InsertionController& insertion)
{
  if (insertion.loading() != nullptr) return showPreparing();
  const InsertionControl& control = insertion.control();
  const haptics::Snapshot& now = control.now();
  stop_->setVisible(control.rendersForce());
  fit();
  const QString hand = QString::fromStdString(control.inputName());
  if (!control.isRunning()) return setDevice(DeviceState::off, progressText(Progress::ready), hand);
  if (now.output.workflow == haptics::Workflow::fault)
    return setDevice(DeviceState::alarm, tr("fault · no force"), insertion.error());
  const haptics::InsertionEnd end = control.earlyEnd();
  if (end != haptics::InsertionEnd::none && end != haptics::InsertionEnd::stoppedByResistance)
    return setDevice(DeviceState::warning, tr("ended · no force"), hand);
  if (control.isStopped())
    return setDevice(DeviceState::warning, tr("stopped · no force"),
                     tr("%1. Press Start to continue.").arg(hand));
  // what still renders force is not off, though its recording is closed
  const Progress progress = control.progress() == Progress::concluded && control.rendersForce()
                                ? Progress::resting
                                : control.progress();
  const DeviceState light =
      progress == Progress::concluded ? DeviceState::off : DeviceState::steady;
  const bool isTimed = progress == Progress::underway && now.measuredRate > 0.0;
  setDevice(
      light, progressText(progress),
      isTimed ? tr("%1, %2 samples per second").arg(hand, numberText(now.measuredRate, 0)) : hand);
}

void TopBar::showPreparing() { setDevice(DeviceState::off, tr("preparing"), {}); }

void TopBar::showReplay()
{
  setDevice(DeviceState::off, tr("replay"), tr("A recording is shown. No device is active."));
}

void TopBar::setDevice(DeviceState light, const QString& caption, const QString& tip)
{
  device_->show(light, caption);
  device_->setToolTip(tip);
}

}  // namespace perilymph::gui
