// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/LoadingStage.h"

#include <QLabel>
#include <QProgressBar>
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
  cancel->setToolTip(tr("Keep the cochlea and array of before (Esc)"));
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
  setVisible(!subject.isEmpty());
  if (subject.isEmpty()) return;
  text_->setText(tr("Building the cochlea: %1").arg(subject));
  place();
  raise();
}

void LoadingStage::place() { setGeometry(parentWidget()->rect()); }

}  // namespace perilymph::gui
