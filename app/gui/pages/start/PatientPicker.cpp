// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/PatientPicker.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/parts/Placeholder.h"
#include "gui/parts/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int width_px = 560;

}  // namespace

PatientPicker::PatientPicker(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      status_(new QLabel(this)),
      open_(new QPushButton(tr("Open"), this)),
      edit_(new QPushButton(tr("Edit…"), this))
{
  setFixedWidth(sized(width_px));
  auto* title = new QLabel(tr("Saved patients"), this);
  title->setFont(typeface(22));
  search_->setObjectName(QStringLiteral("patientSearch"));
  search_->setAccessibleName(tr("Find patients"));
  search_->setFont(typeface(13));
  search_->setFixedHeight(sized(32));
  search_->setClearButtonEnabled(true);
  markPlaceholder(*search_, tr("Find by code or ear"));
  search_->installEventFilter(this);
  list_->setObjectName(QStringLiteral("patientList"));
  list_->setAccessibleName(tr("Saved patients"));
  list_->setFont(typeface(13));
  status_->setFont(typeface(13));
  status_->setProperty("quiet", true);
  auto* back = new QPushButton(tr("Back"), this);
  back->setObjectName(QStringLiteral("leavePickerButton"));
  open_->setObjectName(QStringLiteral("openPatientButton"));
  open_->setProperty("primary", true);
  edit_->setObjectName(QStringLiteral("editPatientButton"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(spacing);
  buttons->addWidget(back);
  buttons->addStretch();
  buttons->addWidget(edit_);
  buttons->addWidget(open_);
  for (QPushButton* button : {back, edit_, open_}) {
    button->setFont(typeface(13, QFont::Medium));
    button->setFixedHeight(sized(32));
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 3 * spacing, 0, 3 * spacing);
  column->setSpacing(spacing);
  column->addWidget(title);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  column->addWidget(status_);
  column->addLayout(buttons);

  connect(search_, &QLineEdit::textChanged, this, &PatientPicker::showMatches);
  connect(search_, &QLineEdit::returnPressed, this, &PatientPicker::openSelected);
  connect(list_, &QListWidget::itemActivated, this, &PatientPicker::openSelected);
  connect(open_, &QPushButton::clicked, this, &PatientPicker::openSelected);
  connect(edit_, &QPushButton::clicked, this, [this] {
    if (const SavedPatient* patient = selected()) Q_EMIT editAsked(SavedPatient(*patient));
  });
  connect(back, &QPushButton::clicked, this, &PatientPicker::leaveAsked);
  setTabOrder(search_, list_);
  setTabOrder(list_, open_);
  setTabOrder(open_, edit_);
  setTabOrder(edit_, back);
  setFocusProxy(search_);
}

void PatientPicker::refresh()
{
  patients_ = savedPatients();
  search_->clear();
  showMatches();
}

void PatientPicker::showMatches()
{
  const QString wanted = search_->text().trimmed();
  list_->clear();
  shown_.clear();
  for (std::size_t i = 0; i < patients_.size(); ++i) {
    const QString name = nameOfPatient(patients_[i].patient);
    if (!name.contains(wanted, Qt::CaseInsensitive)) continue;
    list_->addItem(tr("%1 · %2").arg(name, numbersOfPatient(patients_[i].patient)));
    shown_.push_back(i);
  }
  if (!shown_.empty()) list_->setCurrentRow(0);
  open_->setEnabled(!shown_.empty());
  edit_->setEnabled(!shown_.empty());
  status_->setText(patients_.empty() ? tr("No patient is saved yet.")
                   : shown_.empty()  ? tr("No patient matches “%1”.").arg(wanted)
                                     : tr("%1 of %2").arg(shown_.size()).arg(patients_.size()));
}

const SavedPatient* PatientPicker::selected() const
{
  const int row = list_->currentRow();
  if (row < 0 || row >= int(shown_.size())) return nullptr;
  return &patients_[shown_[std::size_t(row)]];
}

void PatientPicker::openSelected()
{
  if (const SavedPatient* patient = selected()) Q_EMIT openAsked(SavedPatient(*patient));
}

bool PatientPicker::eventFilter(QObject* watched, QEvent* event)
{
  // Up and Down move in the list while the search is typed.
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Up || key == Qt::Key_Down) {
      QCoreApplication::sendEvent(list_, event);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace perilymph::gui
