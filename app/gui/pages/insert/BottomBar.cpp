// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/BottomBar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QVariant>
#include <algorithm>
#include <utility>

#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

ProgressLine::ProgressLine(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("progressLine"));
  setAttribute(Qt::WA_NoSystemBackground);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ProgressLine::setFraction(double fraction)
{
  const double clamped = std::clamp(fraction, 0.0, 1.0);
  if (clamped == fraction_) return;
  fraction_ = clamped;
  update();
}

void ProgressLine::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  constexpr double radius = 5.0;
  const double middle = height() / 2.0;
  const double left = radius, right = width() - radius;
  const double here = left + fraction_ * (right - left);
  painter.setPen(QPen(shownTheme().ahead, 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(left, middle), QPointF(right, middle));
  painter.setPen(QPen(shownTheme().accent, 4.0, Qt::SolidLine, Qt::RoundCap));
  if (fraction_ > 0.0) painter.drawLine(QPointF(left, middle), QPointF(here, middle));
  painter.setPen(Qt::NoPen);
  painter.setBrush(shownTheme().text);
  painter.drawEllipse(QPointF(here, middle), radius, radius);
}

BottomBar::BottomBar(QWidget* parent)
    : QWidget(parent),
      start_(addButton(tr("Start"), "startButton", 104)),
      withdraw_(addButton(tr("Withdraw"), "withdrawButton", 84)),
      reset_(addButton(tr("Reset"), "resetButton", 84)),
      progress_(new ProgressLine(this)),
      time_(new QLabel(this)),
      status_(new QLabel(this))
{
  setFixedHeight(shownLengths().bar);
  start_->setFont(typeface(13, QFont::DemiBold));
  setWait({});
  withdraw_->setToolTip(tr("Withdraw the array (Backspace)"));
  reset_->setToolTip(tr("New insertion and recording (Ctrl+R)"));
  withdraw_->setEnabled(false);

  time_->setFont(typeface(13));
  time_->setProperty("quiet", true);
  time_->setMinimumWidth(sized(56));
  time_->setObjectName(QStringLiteral("timeLabel"));
  time_->setToolTip(
      tr("Recorded time since the first motion; after the insertion time it includes the rest"));
  status_->setFont(typeface(11));
  status_->setProperty("quiet", true);
  status_->setObjectName(QStringLiteral("statusLabel"));
  status_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  status_->setWordWrap(true);  // the text of a device may need several lines
  status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * spacing, 0, 2 * spacing, 0);
  row->setSpacing(spacing);
  row->addWidget(start_);
  row->addWidget(withdraw_);
  row->addWidget(reset_);
  row->addSpacing(2 * spacing);
  row->addWidget(progress_, 5);
  row->addWidget(time_);
  row->addWidget(status_, 5);

  start_->installEventFilter(this);
  connect(start_, &QPushButton::clicked, this, [this] {
    if (std::exchange(hasPaused_, false)) return;
    main_ == Main::start ? Q_EMIT startRequested() : Q_EMIT pauseRequested();
  });
  connect(withdraw_, &QPushButton::clicked, this, &BottomBar::withdrawRequested);
  connect(reset_, &QPushButton::clicked, this, &BottomBar::resetRequested);
}

bool BottomBar::eventFilter(QObject* target, QEvent* event)
{
  if (target == start_ && event->type() == QEvent::MouseButtonRelease && start_->isDown() &&
      main_ == Main::pause) {
    hasPaused_ = true;
    Q_EMIT pauseRequested();
  }
  return QWidget::eventFilter(target, event);
}

QPushButton* BottomBar::addButton(const QString& text, const char* name, int width)
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(QLatin1String(name));
  button->setFont(typeface(13, QFont::Medium));
  button->setFixedHeight(sized(28));
  button->setMinimumWidth(width);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

void BottomBar::setMain(Main action, bool isEnabled)
{
  main_ = action;
  start_->setText(action == Main::start ? tr("Start") : tr("Pause"));
  start_->setEnabled(isEnabled);
}

void BottomBar::setWait(const QString& reason)
{
  start_->setToolTip(reason.isEmpty() ? tr("Start or pause the insertion (Space)") : reason);
}

void BottomBar::setWithdrawEnabled(bool isEnabled) { withdraw_->setEnabled(isEnabled); }

void BottomBar::setProgress(double fraction, double time_s)
{
  progress_->setFraction(fraction);
  time_->setText(tr("%1 s").arg(numberText(time_s, 1)));
}

void BottomBar::setStatus(const QString& label, bool isError)
{
  status_->setText(label);
  status_->setToolTip(label);
  if (status_->property("error").toBool() == isError) return;
  status_->setProperty("error", isError);
  status_->style()->unpolish(status_);
  status_->style()->polish(status_);
}

}  // namespace perilymph::gui
