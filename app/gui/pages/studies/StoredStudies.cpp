// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/StoredStudies.h"

#include <QPushButton>
#include <QVBoxLayout>
#include <stop_token>
#include <utility>

#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

StoredStudies::StoredStudies(QWidget* parent)
    : QWidget(parent),
      list_(new Selector("storedStudies", tr("Studies made here"), this)),
      take_(panelButton(tr("Open"), "openStoredStudyButton", this)),
      reading_(this)
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing / 2);
  column->addWidget(panelHeading(tr("STUDIES MADE HERE"), this));
  column->addWidget(list_);
  column->addWidget(take_);
  connect(list_, &Selector::chosen, this, &StoredStudies::showState);
  connect(take_, &QPushButton::clicked, this, [this] {
    if (chosen() == nullptr) return;
    const StoredStudy study = *chosen();  // the list is read again meanwhile
    Q_EMIT asked(study);
  });
  list({});
}

void StoredStudies::refresh()
{
  reading_.run(
      "The list of studies",
      [](const std::stop_token&) -> Result<std::vector<StoredStudy>> { return storedStudies(); },
      [this](Result<std::vector<StoredStudy>> studies) {
        if (studies) list(*std::move(studies));
      });
}

void StoredStudies::list(std::vector<StoredStudy> studies)
{
  studies_ = std::move(studies);
  list_->clear();
  for (const StoredStudy& each : studies_) {
    const QString folder = QString::fromStdString(each.folder.string());
    list_->addChoice(each.isComplete ? tr("%1 · complete").arg(each.title)
                     : each.cases == 0
                         ? tr("%1 · not begun").arg(each.title)
                         : tr("%1 · %2 of %3").arg(each.title).arg(each.done).arg(each.cases),
                     folder, folder);
  }
  if (studies_.empty()) list_->addChoice(tr("none yet"), QString());
  list_->setCurrentIndex(0);
  showState();
}

const StoredStudy* StoredStudies::chosen() const
{
  const int index = list_->currentIndex();
  return index >= 0 && index < int(studies_.size()) ? &studies_[std::size_t(index)] : nullptr;
}

void StoredStudies::setBusy(bool isBusy)
{
  isBusy_ = isBusy;
  showState();
}

void StoredStudies::showState()
{
  const bool isComplete = chosen() == nullptr || chosen()->isComplete;
  take_->setText(isComplete ? tr("Open") : tr("Continue"));
  take_->setEnabled(chosen() != nullptr && (isComplete || !isBusy_));
}

}  // namespace perilymph::gui
