// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/EmptyPage.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int width_px = 480;

}  // namespace

EmptyPage::EmptyPage(const QString& title, const QString& sentence, QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(title, this)),
      sentence_(new QLabel(sentence, this)),
      action_(new QPushButton(this)),
      other_(new QPushButton(this))
{
  action_->setObjectName(QStringLiteral("emptyPageButton"));
  action_->setProperty("primary", true);
  other_->setObjectName(QStringLiteral("emptyPageOtherButton"));
  for (QPushButton* each : {action_, other_}) {
    each->setFont(typeface(13, QFont::Medium));
    each->setFixedHeight(sized(32));
    each->hide();
  }
  connect(action_, &QPushButton::clicked, this, &EmptyPage::actionRequested);
  connect(other_, &QPushButton::clicked, this, &EmptyPage::otherRequested);
  title_->setFont(typeface(22));
  title_->setAlignment(Qt::AlignCenter);
  sentence_->setFont(typeface(13));
  sentence_->setProperty("quiet", true);
  sentence_->setAlignment(Qt::AlignCenter);
  sentence_->setWordWrap(true);
  sentence_->setFixedWidth(sized(width_px));
  auto* column = new QVBoxLayout(this);
  column->setSpacing(2 * spacing);
  column->addStretch(2);
  column->addWidget(title_);
  column->addWidget(sentence_, 0, Qt::AlignHCenter);
  column->addWidget(action_, 0, Qt::AlignHCenter);
  column->addWidget(other_, 0, Qt::AlignHCenter);
  column->addStretch(3);
  showMessage(title, sentence);
}

void EmptyPage::showMessage(const QString& title, const QString& sentence)
{
  title_->setText(title);
  sentence_->setText(sentence);
  // height of all its lines; without text there is none
  sentence_->setMinimumHeight(std::max(0, sentence_->heightForWidth(sized(width_px))));
}

void EmptyPage::offer(const QString& action)
{
  action_->setText(action);
  action_->setVisible(!action.isEmpty());
}

void EmptyPage::offerAlso(const QString& action)
{
  other_->setText(action);
  other_->setVisible(!action.isEmpty());
}

void EmptyPage::offerMenu(const QString& title, QMenu* menu)
{
  auto* button = new QPushButton(title, this);
  button->setObjectName(QStringLiteral("emptyPageMenuButton"));
  button->setFont(typeface(13, QFont::Medium));
  button->setFixedHeight(sized(32));
  button->setMenu(menu);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->insertWidget(column->indexOf(other_) + 1, button, 0, Qt::AlignHCenter);
}

}  // namespace perilymph::gui
