// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/KioskScreen.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/kiosk/LeaderboardView.h"
#include "gui/kiosk/SpeedPad.h"
#include "gui/scene/ForceLabel.h"
#include "gui/scene/OperationView.h"
#include "gui/scene/PhaseLine.h"
#include "gui/widgets/ReadOut.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int buttonHeight_px = 96;  // twice the size of a touch target
constexpr int headHeight_px = 124;
constexpr Speed back = millimetersPerSecond(3);

/// Captions on the picture that are read from a distance, without what visitors do not know.
void captionForVisitors(const OperationView& view)
{
  for (ReadOut* number : view.findChildren<ReadOut*>())
    number->setCaptionSize(KioskScreen::label_px);
  view.findChild<PhaseLine*>()->setNameSize(KioskScreen::label_px);
  view.findChild<ForceLabel*>()->setForVisitors(KioskScreen::label_px);
  view.findChild<QLabel*>(QStringLiteral("viewLabel"))->setFont(typeface(KioskScreen::label_px));
  view.findChild<QLabel*>(QStringLiteral("magnificationLabel"))->hide();
}

}  // namespace

KioskScreen::KioskScreen(QWidget* window)
    : QWidget(window),
      title_(new QLabel(this)),
      sentence_(new QLabel(this)),
      view_(new OperationView(this)),
      board_(new LeaderboardView(this)),
      foot_(new QStackedWidget(this))
{
  captionForVisitors(*view_);
  title_->setObjectName(QStringLiteral("kioskTitle"));
  title_->setFont(typeface(34, QFont::Light));
  sentence_->setObjectName(QStringLiteral("kioskSentence"));
  sentence_->setFont(typeface(20));
  sentence_->setProperty("quiet", true);
  sentence_->setWordWrap(true);
  auto* head = new QWidget(this);
  head->setFixedHeight(headHeight_px);
  auto* label = new QVBoxLayout(head);
  label->setContentsMargins(4 * spacing, 2 * spacing, 4 * spacing, spacing);
  label->setSpacing(4);
  label->addWidget(title_);
  label->addWidget(sentence_);
  label->addStretch();

  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  middle->addWidget(view_, 1);
  middle->addWidget(board_);

  foot_->addWidget(addInvitation());
  foot_->addWidget(addTurnFoot());
  foot_->addWidget(addResultFoot());
  foot_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* quiet = new QLabel(tr("Simulation for research and training. Not a medical device."), this);
  quiet->setFont(typeface(13));
  quiet->setProperty("quiet", true);
  quiet->setAlignment(Qt::AlignCenter);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, spacing);
  column->setSpacing(0);
  column->addWidget(head);
  column->addLayout(middle, 1);
  column->addWidget(foot_);
  column->addWidget(quiet);
}

QPushButton* KioskScreen::addButton(const QString& text, const char* name, QWidget* parent)
{
  auto* button = new QPushButton(text, parent);
  button->setObjectName(QLatin1String(name));
  button->setFont(typeface(22, QFont::Medium));
  button->setFixedHeight(buttonHeight_px);
  button->setMinimumWidth(2 * buttonHeight_px);
  button->setFocusPolicy(Qt::NoFocus);
  return button;
}

QWidget* KioskScreen::addInvitation()
{
  auto* page = new QWidget(foot_);
  auto* row = new QHBoxLayout(page);
  auto* invite = addButton(tr("Touch anywhere to try it yourself"), "inviteButton", page);
  invite->setProperty("primary", true);
  invite->setFont(typeface(28, QFont::DemiBold));
  row->addWidget(invite, 1);
  return page;
}

QWidget* KioskScreen::addTurnFoot()
{
  auto* page = new QWidget(foot_);
  auto* row = new QHBoxLayout(page);
  row->setSpacing(2 * spacing);
  pull_ = addButton(tr("Hold to withdraw"), "pullButton", page);
  pad_ = new SpeedPad(page);
  handle_ = addButton(tr("Use the haptic device"), "handleButton", page);
  stop_ = addButton(tr("STOP"), "stopButton", page);
  stop_->setFont(typeface(34, QFont::Bold));
  stop_->setAccessibleName(tr("Stop: remove the force of the device"));
  auto* again = addButton(tr("Start over"), "startOverButton", page);
  row->addWidget(pull_);
  row->addWidget(pad_, 1);
  row->addWidget(stop_, 1);
  row->addWidget(handle_);
  row->addWidget(again);
  handle_->hide();
  stop_->hide();
  connect(stop_, &QPushButton::pressed, this, &KioskScreen::stopRequested);
  connect(again, &QPushButton::clicked, this, &KioskScreen::startOverRequested);
  connect(handle_, &QPushButton::clicked, this, &KioskScreen::handleRequested);
  return page;
}

QWidget* KioskScreen::addResultFoot()
{
  auto* page = new QWidget(foot_);
  auto* row = new QHBoxLayout(page);
  row->setSpacing(2 * spacing);
  auto* leave = addButton(tr("Done"), "doneButton", page);
  auto* again = addButton(tr("Try again"), "againButton", page);
  again->setProperty("primary", true);
  row->addWidget(leave);
  row->addWidget(again, 1);
  connect(again, &QPushButton::clicked, this, &KioskScreen::startOverRequested);
  connect(leave, &QPushButton::clicked, this, &KioskScreen::leaveRequested);
  return page;
}

void KioskScreen::showMessage(const QString& title, const QString& sentence)
{
  title_->setText(title);
  sentence_->setText(sentence);
}

void KioskScreen::showFooter(KioskStage stage) { foot_->setCurrentIndex(static_cast<int>(stage)); }

void KioskScreen::offerHandle(bool isThere) { handle_->setVisible(isThere); }

void KioskScreen::useHandle(bool isHandle)
{
  handle_->setText(isHandle ? tr("Use the screen") : tr("Use the haptic device"));
  pad_->setVisible(!isHandle);
  pull_->setVisible(!isHandle);
  stop_->setVisible(isHandle);
}

bool KioskScreen::isStop(const QObject* target) const { return target == stop_; }

bool KioskScreen::isPressed() const { return pad_->isHeld() || pull_->isDown(); }

Speed KioskScreen::speed() const
{
  if (pad_->isHeld()) return pad_->speed();
  return pull_->isDown() ? Speed::fromSi(-back.si()) : Speed{};
}

void KioskScreen::release()
{
  pad_->release();
  pull_->setDown(false);
}

}  // namespace perilymph::gui
