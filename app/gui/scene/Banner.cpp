// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/Banner.h"

#include <QHBoxLayout>
#include <QLabel>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

Banner::Banner(QWidget* parent) : QFrame(parent), text_(new QLabel(this))
{
  setObjectName(QStringLiteral("banner"));
  text_->setObjectName(QStringLiteral("bannerText"));
  text_->setFont(typeface(13));
  text_->setWordWrap(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * spacing, spacing, 2 * spacing, spacing);
  row->addWidget(text_);
  hide();
}

void Banner::setSentence(const QString& sentence)
{
  if (text_->text() == sentence) return;
  text_->setText(sentence);
  setVisible(!sentence.isEmpty());
}

}  // namespace perilymph::gui
