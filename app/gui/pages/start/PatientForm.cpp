// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/PatientForm.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/parts/CheckBoxes.h"
#include "gui/parts/Theme.h"
#include "gui/setup/PopulationField.h"
#include "gui/setup/Populations.h"
#include "perilymph/anatomy/Population.h"

namespace perilymph::gui {

namespace {

constexpr int formWidth_px = 420;

QLabel* heading(const QString& text, QWidget* parent)
{
  auto* label = new QLabel(text, parent);
  label->setFont(typeface(11, QFont::DemiBold));
  label->setProperty("quiet", true);
  return label;
}

QHBoxLayout* sideBySide(QWidget* first, QWidget* second)
{
  auto* row = new QHBoxLayout;
  row->setSpacing(3 * spacing);
  row->addWidget(first);
  row->addWidget(second);
  row->addStretch();
  return row;
}

}  // namespace

PatientForm::PatientForm(QWidget* parent)
    : QWidget(parent),
      label_(new QLineEdit(this)),
      right_(new Choice(tr("right"), this)),
      left_(new Choice(tr("left"), this)),
      byLengths_(new Choice(tr("CDL and round-window section"), this)),
      byBasalTurn_(new Choice(tr("A, B and H"), this)),
      numbers_(new QStackedWidget(this)),
      error_(new QLabel(this)),
      use_(new QPushButton(tr("Build cochlea"), this))
{
  setFixedWidth(formWidth_px);
  label_->setObjectName(QStringLiteral("patientName"));
  label_->setAccessibleName(tr("Patient"));
  label_->setFont(typeface(13));
  label_->setFixedHeight(28);
  label_->setMaxLength(60);
  label_->setPlaceholderText(tr("Patient code (no names)"));
  byLengths_->setObjectName(QStringLiteral("byLengths"));
  byBasalTurn_->setObjectName(QStringLiteral("byBasalTurn"));
  right_->setObjectName(QStringLiteral("rightEar"));
  left_->setObjectName(QStringLiteral("leftEar"));
  for (Choice* choice : {right_, left_, byLengths_, byBasalTurn_})
    choice->setFocusPolicy(Qt::TabFocus);
  auto* ears = new QButtonGroup(this);
  ears->addButton(right_);
  ears->addButton(left_);
  auto* ways = new QButtonGroup(this);
  ways->addButton(byLengths_);
  ways->addButton(byBasalTurn_);

  numbers_->addWidget(addLengths());
  numbers_->addWidget(addBasalTurn());
  error_->setFont(typeface(13));
  error_->setWordWrap(true);
  error_->setProperty("error", true);
  error_->hide();

  auto* back = new QPushButton(tr("Back"), this);
  back->setObjectName(QStringLiteral("leavePatientButton"));
  use_->setObjectName(QStringLiteral("usePatientButton"));
  use_->setProperty("primary", true);
  use_->setDefault(true);
  for (QPushButton* button : {back, use_}) {
    button->setFont(typeface(13, QFont::Medium));
    button->setFixedHeight(32);
  }

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  auto* title = new QLabel(tr("Patient measurements"), this);
  title->setFont(typeface(22));
  column->addWidget(title);
  column->addSpacing(spacing);
  column->addWidget(heading(tr("PATIENT"), this));
  column->addWidget(label_);
  column->addSpacing(spacing);
  column->addWidget(heading(tr("EAR"), this));
  column->addLayout(sideBySide(right_, left_));
  column->addSpacing(spacing);
  column->addWidget(heading(tr("CT MEASUREMENTS"), this));
  column->addLayout(sideBySide(byLengths_, byBasalTurn_));
  column->addWidget(numbers_);
  column->addWidget(error_);
  column->addSpacing(2 * spacing);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(back);
  buttons->addStretch();
  buttons->addWidget(use_);
  column->addLayout(buttons);

  connect(byLengths_, &QAbstractButton::toggled, this, [this](bool isOn) {
    numbers_->setCurrentIndex(isOn ? 0 : 1);
    showState();
  });
  connect(label_, &QLineEdit::textChanged, this, [this] { showState(); });
  connect(back, &QPushButton::clicked, this, &PatientForm::leaveAsked);
  connect(use_, &QPushButton::clicked, this, [this] { Q_EMIT patientGiven(patient()); });
  anatomy::Patient first;
  first.label.clear();
  setPatient(first);
}

QWidget* PatientForm::addLengths()
{
  auto* page = new QWidget(numbers_);
  length_ = new PopulationField(tr("Cochlear duct length (organ of Corti)"), "stLength",
                                scalaLengthPopulation(), false, page);
  width_ = new PopulationField(tr("Scala width at round window"), "rwWidth",
                               windowWidthPopulation(), false, page);
  height_ = new PopulationField(tr("Scala height at round window"), "rwHeight",
                                windowHeightPopulation(), false, page);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  for (PopulationField* field : {length_, width_, height_}) {
    column->addWidget(field);
    connect(field, &PopulationField::changed, this, [this] { showState(); });
  }
  return page;
}

QWidget* PatientForm::addBasalTurn()
{
  auto* page = new QWidget(numbers_);
  a_ =
      new PopulationField(tr("A: basal-turn diameter"), "aValue", lengthAPopulation(), false, page);
  b_ = new PopulationField(tr("B: basal-turn width, perpendicular to A"), "bValue",
                           widthBPopulation(), false, page);
  h_ = new PopulationField(tr("H: cochlear height"), "hValue", heightHPopulation(), true, page);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  for (PopulationField* field : {a_, b_, h_}) {
    column->addWidget(field);
    connect(field, &PopulationField::changed, this, [this] { showState(); });
  }
  return page;
}

void PatientForm::setPatient(const anatomy::Patient& patient)
{
  label_->setText(QString::fromStdString(patient.label));
  (patient.side == anatomy::Side::left ? left_ : right_)->setChecked(true);
  length_->setValue(patient.scalaTympaniLength);
  width_->setValue(patient.roundWindowWidth);
  height_->setValue(patient.roundWindowHeight);
  const anatomy::BasalTurn turn = patient.basalTurn.value_or(
      anatomy::BasalTurn{anatomy::spreadOfA().mean, anatomy::spreadOfB().mean, std::nullopt});
  a_->setValue(turn.a);
  b_->setValue(turn.b);
  h_->setValue(turn.h);
  (patient.basalTurn ? byBasalTurn_ : byLengths_)->setChecked(true);
  showError({});
  showState();
}

anatomy::Patient PatientForm::patient() const
{
  anatomy::Patient patient;
  const QString name = label_->text().trimmed();
  patient.label = name.isEmpty() ? tr("unnamed").toStdString() : name.toStdString();
  patient.side = left_->isChecked() ? anatomy::Side::left : anatomy::Side::right;
  if (byBasalTurn_->isChecked()) {
    patient.basalTurn = anatomy::BasalTurn{a_->value().value_or(Length{}),
                                           b_->value().value_or(Length{}), h_->value()};
  } else {
    patient.scalaTympaniLength = length_->value().value_or(Length{});
    patient.roundWindowWidth = width_->value().value_or(Length{});
    patient.roundWindowHeight = height_->value().value_or(Length{});
  }
  return patient;
}

void PatientForm::showError(const QString& sentence)
{
  error_->setText(sentence);
  error_->setVisible(!sentence.isEmpty());
}

bool PatientForm::isAcceptable() const
{
  if (byBasalTurn_->isChecked())
    return a_->isAcceptable() && b_->isAcceptable() && h_->isAcceptable();
  return length_->isAcceptable() && width_->isAcceptable() && height_->isAcceptable();
}

void PatientForm::showState() { use_->setEnabled(isAcceptable()); }

}  // namespace perilymph::gui
