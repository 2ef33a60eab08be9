// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/Notice.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "gui/parts/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int time_ms = 6000;
constexpr int max_px = 760;

}  // namespace

Notice::Notice(QWidget* parent)
    : QFrame(parent),
      label_(new QLabel(this)),
      act_(new QPushButton(this)),
      dismiss_(new QPushButton(tr("Dismiss"), this))
{
  setObjectName(QStringLiteral("notice"));
  label_->setObjectName(QStringLiteral("noticeText"));
  label_->setFont(typeface(13));
  label_->setWordWrap(true);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  act_->setObjectName(QStringLiteral("noticeButton"));
  dismiss_->setObjectName(QStringLiteral("noticeDismissButton"));
  for (QPushButton* button : {act_, dismiss_}) {
    button->setFont(typeface(13, QFont::Medium));
    button->setFixedHeight(28);
    button->setFocusPolicy(Qt::TabFocus);
  }
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * spacing, spacing, spacing, spacing);
  row->setSpacing(spacing);
  row->addWidget(label_, 1);
  row->addWidget(act_);
  row->addWidget(dismiss_);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &QWidget::hide);
  connect(dismiss_, &QPushButton::clicked, this, &QWidget::hide);
  connect(act_, &QPushButton::clicked, this, [this] {
    hide();
    if (action_) action_();
  });
  parent->installEventFilter(this);
  hide();
}

void Notice::say(const QString& sentence)
{
  label_->setText(sentence);
  action_ = nullptr;
  act_->hide();
  timer_.start(time_ms);
  place();
}

void Notice::offer(const QString& sentence, const QString& action, std::function<void()> act)
{
  label_->setText(sentence);
  act_->setText(action);
  act_->show();
  action_ = std::move(act);
  timer_.stop();
  place();
}

QString Notice::sentence() const { return label_->text(); }

void Notice::place()
{
  const QWidget& around = *parentWidget();
  setFixedWidth(std::min(max_px, around.width() - 4 * spacing));
  adjustSize();
  move((around.width() - width()) / 2, around.height() - height() - barHeight - 2 * spacing);
  show();
  raise();
}

bool Notice::eventFilter(QObject* target, QEvent* event)
{
  if (event->type() == QEvent::Resize && isVisible()) place();
  return QFrame::eventFilter(target, event);
}

}  // namespace perilymph::gui
