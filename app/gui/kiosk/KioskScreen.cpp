// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/KioskScreen.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/kiosk/DayView.h"
#include "gui/kiosk/Legibility.h"
#include "gui/kiosk/LevelGauge.h"
#include "gui/kiosk/QrView.h"
#include "gui/kiosk/SpeedPad.h"
#include "gui/scene/OperationView.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

// Lengths in sizes of the type (choices).
constexpr double titleSize = preferredLetter_arcmin / minLetter_arcmin;
constexpr double smallPrintSize = 0.45;  // a footnote
constexpr double lineHeight = 1.25;
constexpr double buttonHeight = 2.8;  // two lines
constexpr double languageHeight = 1.8, languageWidth = 5.0;
constexpr double panelWidth = 10.0, gaugeWidth = 9.0;
constexpr double padWidth = 10.0;
// A window has room for so many letters of the size.
constexpr double lettersAcross = 36.0, lettersDown = 21.0;
constexpr int smallest_px = 9;
constexpr Speed back = millimetersPerSecond(3);

}  // namespace

KioskScreen::KioskScreen(QWidget* window)
    : QWidget(window),
      title_(new QLabel(this)),
      sentence_(new QLabel(this)),
      view_(new OperationView(this)),
      day_(new DayView(this)),
      gauge_(new LevelGauge(this)),
      foot_(new QStackedWidget(this)),
      smallPrint_(new QLabel(this))
{
  auto* middle = new QHBoxLayout;
  middle->setContentsMargins(0, 0, 2 * spacing, 0);
  middle->setSpacing(2 * spacing);
  middle->addWidget(view_, 1);
  middle->addWidget(day_);
  middle->addWidget(gauge_);
  middle->addWidget(addCode());

  foot_->addWidget(addInvitation());
  foot_->addWidget(addTurnFoot());
  foot_->addWidget(addResultFoot());
  foot_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  smallPrint_->setProperty("quiet", true);
  smallPrint_->setAlignment(Qt::AlignCenter);
  smallPrint_->setWordWrap(true);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, spacing / 2);
  column->setSpacing(0);
  column->addWidget(addHead());
  column->addLayout(middle, 1);
  column->addWidget(foot_);
  column->addWidget(smallPrint_);
  fit();
  retranslate();
  showStage(KioskStage::attract);
}

QWidget* KioskScreen::addHead()
{
  auto* head = new QWidget(this);
  title_->setObjectName(QStringLiteral("kioskTitle"));
  sentence_->setObjectName(QStringLiteral("kioskSentence"));
  sentence_->setProperty("quiet", true);
  sentence_->setWordWrap(true);
  sentence_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  language_ = addButton("languageButton", head);
  connect(language_, &QPushButton::clicked, this, &KioskScreen::otherLanguageRequested);
  auto* row = new QHBoxLayout;
  row->addWidget(title_, 1);
  row->addWidget(language_);
  auto* column = new QVBoxLayout(head);
  column->setContentsMargins(2 * spacing, spacing, 2 * spacing, spacing / 2);
  column->setSpacing(spacing / 2);
  column->addLayout(row);
  column->addWidget(sentence_);
  return head;
}

QWidget* KioskScreen::addCode()
{
  code_ = new QWidget(this);
  qr_ = new QrView(code_);
  scan_ = new QLabel(code_);
  scan_->setWordWrap(true);
  scan_->setAlignment(Qt::AlignCenter);
  auto* column = new QVBoxLayout(code_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(qr_, 1);
  column->addWidget(scan_);
  return code_;
}

QPushButton* KioskScreen::addButton(const char* name, QWidget* parent)
{
  auto* button = new QPushButton(parent);
  button->setObjectName(QLatin1String(name));
  button->setFocusPolicy(Qt::NoFocus);
  return button;
}

QWidget* KioskScreen::addInvitation()
{
  auto* page = new QWidget(foot_);
  auto* row = new QHBoxLayout(page);
  invite_ = addButton("inviteButton", page);
  invite_->setProperty("primary", true);
  row->addWidget(invite_, 1);
  return page;
}

QWidget* KioskScreen::addTurnFoot()
{
  auto* page = new QWidget(foot_);
  auto* row = new QHBoxLayout(page);
  row->setSpacing(spacing);
  pull_ = addButton("pullButton", page);
  pad_ = new SpeedPad(page);
  handle_ = addButton("handleButton", page);
  stop_ = addButton("stopButton", page);
  startOver_ = addButton("startOverButton", page);
  row->addWidget(pull_);
  row->addWidget(pad_, 1);
  row->addWidget(stop_, 1);
  row->addWidget(handle_);
  row->addWidget(startOver_);
  handle_->hide();
  stop_->hide();
  connect(stop_, &QPushButton::pressed, this, &KioskScreen::stopRequested);
  connect(startOver_, &QPushButton::clicked, this, &KioskScreen::startOverRequested);
  connect(handle_, &QPushButton::clicked, this, &KioskScreen::handleRequested);
  return page;
}

QWidget* KioskScreen::addResultFoot()
{
  auto* page = new QWidget(foot_);
  auto* row = new QHBoxLayout(page);
  row->setSpacing(2 * spacing);
  done_ = addButton("doneButton", page);
  again_ = addButton("againButton", page);
  again_->setProperty("primary", true);
  row->addWidget(done_);
  row->addWidget(again_, 1);
  connect(again_, &QPushButton::clicked, this, &KioskScreen::startOverRequested);
  connect(done_, &QPushButton::clicked, this, &KioskScreen::leaveRequested);
  return page;
}

void KioskScreen::retranslate()
{
  // each language in its own name
  language_->setText(QLocale().language() == QLocale::German ? QStringLiteral("English")
                                                             : QStringLiteral("Deutsch"));
  invite_->setText(tr("Touch anywhere to try it yourself"));
  pull_->setText(tr("Hold to\nwithdraw"));
  pad_->retranslate();
  stop_->setText(tr("STOP"));
  stop_->setAccessibleName(tr("Stop: remove the force of the device"));
  startOver_->setText(tr("Start\nover"));
  handle_->setText(isHandle_ ? tr("Use the\nscreen") : tr("Use the\nhaptic device"));
  done_->setText(tr("Done"));
  again_->setText(tr("Try again"));
  scan_->setText(tr("Scan to keep your force curve"));
  smallPrint_->setText(tr("Simulation for research and training. Not a medical device.") +
                       QLatin1Char(' ') + source_);
  day_->retranslate();
  gauge_->update();
  view_->retranslate();
}

int KioskScreen::lengthOf(double letters) const { return sized(qRound(letters * letter_px_)); }

void KioskScreen::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  fit();
}

void KioskScreen::fit()
{
  // type that the user made smaller is legible all the same
  const double wanted =
      letterSize_px(minLetter_arcmin, pixelPitch_mm(screen())) / std::min(1.0, textScale());
  const double room = std::min(width() / lettersAcross, height() / lettersDown) / textScale();
  const int letter_px = std::max(smallest_px, static_cast<int>(std::min(wanted, room)));
  if (letter_px == letter_px_) return;
  letter_px_ = letter_px;

  title_->setFont(typeface(qRound(titleSize * letter_px_), QFont::Light));
  sentence_->setFont(typeface(letter_px_));
  sentence_->setFixedHeight(2 * lengthOf(lineHeight));
  smallPrint_->setFont(typeface(std::max(smallest_px, qRound(smallPrintSize * letter_px_))));
  scan_->setFont(typeface(letter_px_));
  for (QPushButton* button : {invite_, pull_, handle_, stop_, startOver_, done_, again_}) {
    button->setFont(typeface(letter_px_, QFont::Medium));
    button->setFixedHeight(lengthOf(buttonHeight));
  }
  for (QPushButton* button : {invite_, stop_})
    button->setFont(typeface(qRound(titleSize * letter_px_), QFont::DemiBold));
  language_->setFont(typeface(letter_px_, QFont::Medium));
  language_->setFixedHeight(lengthOf(languageHeight));
  language_->setMinimumWidth(lengthOf(languageWidth));
  done_->setMinimumWidth(lengthOf(panelWidth));
  pad_->setLetterSize(letter_px_);
  pad_->setFixedHeight(lengthOf(buttonHeight));
  pad_->setMinimumWidth(lengthOf(padWidth));
  day_->setFixedWidth(lengthOf(panelWidth));
  day_->setLetterSize(letter_px_);
  gauge_->setFixedWidth(lengthOf(gaugeWidth));
  gauge_->setLetterSize(letter_px_);
  code_->setFixedWidth(lengthOf(panelWidth));
  view_->setForVisitors(letter_px_);
  Q_EMIT letterSizeChanged();
}

void KioskScreen::showMessage(const QString& title, const QString& sentence)
{
  title_->setText(title);
  sentence_->setText(sentence);
}

void KioskScreen::showStage(KioskStage stage)
{
  stage_ = stage;
  foot_->setCurrentIndex(static_cast<int>(stage));
  day_->setVisible(stage != KioskStage::turn);
  gauge_->setVisible(stage == KioskStage::turn);
  code_->setVisible(stage == KioskStage::result && !qr_->text().isEmpty());
}

void KioskScreen::showCode(const QString& text)
{
  qr_->setText(text);
  code_->setVisible(stage_ == KioskStage::result && !text.isEmpty());
}

void KioskScreen::setSource(const QString& source)
{
  source_ = source;
  retranslate();
}

void KioskScreen::offerHandle(bool isThere) { handle_->setVisible(isThere); }

void KioskScreen::useHandle(bool isHandle)
{
  isHandle_ = isHandle;
  pad_->setVisible(!isHandle);
  pull_->setVisible(!isHandle);
  stop_->setVisible(isHandle);
  retranslate();
}

bool KioskScreen::isStop(const QObject* target) const { return target == stop_; }

bool KioskScreen::isLanguage(const QObject* target) const { return target == language_; }

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
