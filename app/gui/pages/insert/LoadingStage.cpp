// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/LoadingStage.h"

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

LoadingStage::LoadingStage(QWidget* page) : QFrame(page), text_(new QLabel(this))
{
  setObjectName(QStringLiteral("loadingStage"));
  setAutoFillBackground(true);
  text_->setObjectName(QStringLiteral("loadingText"));
  text_->setFont(typeface(15));
  text_->setTextFormat(Qt::PlainText);  // a code may look like markup
  auto* bar = new QProgressBar(this);   // the duration is unknown
  bar->setRange(0, 0);
  bar->setTextVisible(false);
  bar->setFixedSize(240, 6);
  auto* cancel = panelButton(tr("Cancel"), "cancelLoadingButton", this);
  cancel->setToolTip(tr("Keep the cochlea and array of before (Esc)"));
  connect(cancel, &QPushButton::clicked, this, &LoadingStage::cancelAsked);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(2 * spacing);
  column->addStretch();
  for (QWidget* part :
       {static_cast<QWidget*>(text_), static_cast<QWidget*>(bar), static_cast<QWidget*>(cancel)})
    column->addWidget(part, 0, Qt::AlignHCenter);
  column->addStretch();
  page->installEventFilter(this);
  hide();
}

void LoadingStage::show(const QString& subject)
{
  setVisible(!subject.isEmpty());
  if (subject.isEmpty()) return;
  text_->setText(tr("Building the cochlea: %1").arg(subject));
  setGeometry(parentWidget()->rect());
  raise();
}

bool LoadingStage::eventFilter(QObject* target, QEvent* event)
{
  if (event->type() == QEvent::Resize && !isHidden()) setGeometry(parentWidget()->rect());
  return QFrame::eventFilter(target, event);
}

}  // namespace perilymph::gui
