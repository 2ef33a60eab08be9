// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/LoadingStage.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

LoadingStage::LoadingStage(QWidget* page) : Overlay(page), text_(new QLabel(this))
{
  setObjectName(QStringLiteral("loadingStage"));
  setAutoFillBackground(true);
  text_->setObjectName(QStringLiteral("loadingText"));
  text_->setFont(typeface(15));
  text_->setTextFormat(Qt::PlainText);  // a code may look like markup
  QProgressBar* bar = endlessBar(240, this);
  auto* cancel = panelButton(tr("Cancel"), "cancelLoadingButton", this);
  cancel_ = cancel;
  connect(cancel, &QPushButton::clicked, this, &LoadingStage::cancelRequested);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(2 * spacing);
  column->addStretch();
  for (QWidget* part :
       {static_cast<QWidget*>(text_), static_cast<QWidget*>(bar), static_cast<QWidget*>(cancel)})
    column->addWidget(part, 0, Qt::AlignHCenter);
  column->addStretch();
  hide();
}

void LoadingStage::show(const QString& subject)
{
  cover(subject.isEmpty() ? QString() : tr("Building the cochlea: %1").arg(subject),
        tr("Keep the cochlea and array of before (Esc)"));
}

void LoadingStage::showDevice(const QString& sentence)
{
  cover(sentence, tr("The scripted insertion remains the input (Esc)"));
}

void LoadingStage::cover(const QString& sentence, const QString& afterCancel)
{
  setVisible(!sentence.isEmpty());
  if (sentence.isEmpty()) return;
  text_->setText(sentence);
  cancel_->setToolTip(afterCancel);
  place();
  raise();
}

void LoadingStage::place() { setGeometry(parentWidget()->rect()); }

}  // namespace perilymph::gui
