// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/Notice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <utility>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int messageTime_ms = 6000;
constexpr int offerTime_ms = 30'000;

}  // namespace

Notice::Notice(QWidget* parent)
    : QFrame(parent),
      label_(new QLabel(this)),
      act_(new QPushButton(this)),
      dismiss_(new QPushButton(this))
{
  setObjectName(QStringLiteral("notice"));
  label_->setObjectName(QStringLiteral("noticeText"));
  label_->setFont(typeface(13));
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  act_->setObjectName(QStringLiteral("noticeButton"));
  dismiss_->setObjectName(QStringLiteral("noticeDismissButton"));
  for (QPushButton* button : {act_, dismiss_}) {
    button->setFont(typeface(13, QFont::Medium));
    button->setFixedHeight(sized(28));
    button->setFocusPolicy(Qt::TabFocus);
  }
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * spacing, spacing, 2 * spacing, spacing);
  row->setSpacing(spacing);
  row->addWidget(label_, 1);
  row->addWidget(act_);
  row->addWidget(dismiss_);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &QWidget::hide);
  connect(dismiss_, &QPushButton::clicked, this, &QWidget::hide);
  connect(act_, &QPushButton::clicked, this, [this] {
    hide();
    if (const auto act = action_) act();  // which may ask again
  });
  hide();
}

void Notice::showMessage(const QString& sentence)
{
  if (sentence.isEmpty()) return;
  show(sentence, {}, tr("Dismiss"), nullptr);
  timer_.start(messageTime_ms);
}

void Notice::offer(const QString& sentence, const QString& action, std::function<void()> act)
{
  show(sentence, action, tr("Dismiss"), std::move(act));
  timer_.start(offerTime_ms);
}

void Notice::ask(const QString& question, const QString& action, const QString& refusal,
                 std::function<void()> act)
{
  show(question, action, refusal, std::move(act));
}

void Notice::dropOffer()
{
  if (timer_.isActive()) hide();
}

void Notice::dropQuestion(const QString& question)
{
  if (!timer_.isActive() && sentence() == question) hide();
}

QString Notice::sentence() const { return label_->text(); }

void Notice::show(const QString& sentence, const QString& action, const QString& refusal,
                  std::function<void()> act)
{
  timer_.stop();
  label_->setText(sentence);
  act_->setText(action);
  act_->setVisible(!action.isEmpty());
  dismiss_->setText(refusal);
  action_ = std::move(act);
  setVisible(true);
}

}  // namespace perilymph::gui
