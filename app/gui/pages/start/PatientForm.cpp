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
#include <algorithm>

#include "gui/setup/DerivedMeasures.h"
#include "gui/setup/EnteredMeasures.h"
#include "gui/setup/LandmarkDrawing.h"
#include "gui/setup/PopulationField.h"
#include "gui/setup/Populations.h"
#include "gui/text/DataText.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/Placeholder.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

constexpr int formWidth_px = 420;
constexpr int explanationWidth_px = 440;
constexpr auto exampleArray = "flex28";  // a straight one; the array is chosen on the next page

QLabel* text(const QString& caption, int size_px, QWidget* parent, bool isQuiet = true)
{
  auto* label = new WrappedLabel(caption, parent);
  label->setFont(typeface(size_px));
  label->setProperty("quiet", isQuiet);
  return label;
}

QLabel* heading(const QString& caption, QWidget* parent)
{
  auto* label = new QLabel(caption, parent);
  label->setFont(typeface(11, QFont::DemiBold));
  label->setProperty("quiet", true);
  return label;
}

QLabel* errorLabel(QWidget* parent)
{
  QLabel* label = text({}, 11, parent, false);
  label->setProperty("error", true);
  label->hide();
  return label;
}

void showMessage(QLabel& label, const QString& sentence)
{
  label.setText(sentence);
  label.setVisible(!sentence.isEmpty());
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

PatientForm::PatientForm(std::shared_ptr<CochleaStore> cochleae, QWidget* parent)
    : QWidget(parent),
      title_(text({}, 22, this, false)),
      label_(new QLineEdit(this)),
      labelError_(errorLabel(this)),
      right_(new Choice(tr("right"), this)),
      left_(new Choice(tr("left"), this)),
      byBasalTurn_(new Choice(tr("A, B and H"), this)),
      byLengths_(new Choice(tr("CDL and round-window section"), this)),
      numbers_(new QStackedWidget(this)),
      warning_(errorLabel(this)),
      error_(errorLabel(this)),
      back_(new QPushButton(tr("Back"), this)),
      use_(new QPushButton(this)),
      landmarks_(new LandmarkDrawing(this)),
      derived_(new DerivedMeasures(std::move(cochleae), this))
{
  if (const auto file = findByName("array", "plugins/electrodes", exampleArray))
    if (const auto array = electrode::loadArray(*file)) array_ = *array;
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 2 * spacing, 0, spacing);
  row->setSpacing(4 * spacing);
  setMaximumWidth(sized(formWidth_px) + 4 * spacing + sized(explanationWidth_px));
  row->addWidget(addForm(), 0, Qt::AlignVCenter);
  row->addWidget(addExplanations(), 1);
  connectFields();
  setTabOrders();
  beginNew();
}

QWidget* PatientForm::addForm()
{
  auto* form = new QWidget(this);
  form->setFixedWidth(sized(formWidth_px));
  label_->setObjectName(QStringLiteral("patientName"));
  label_->setAccessibleName(tr("Patient code"));
  label_->setFont(typeface(13));
  label_->setFixedHeight(sized(28));
  label_->setMaxLength(60);
  label_->setToolTip(
      tr("Letters, digits and hyphens, such as P-017. It appears in file names and "
         "reports."));
  markPlaceholder(*label_, tr("Patient code (no names)"));
  byLengths_->setObjectName(QStringLiteral("byLengths"));
  byLengths_->setToolTip(notInClinicalCt());
  byBasalTurn_->setObjectName(QStringLiteral("byBasalTurn"));
  right_->setObjectName(QStringLiteral("rightEar"));
  left_->setObjectName(QStringLiteral("leftEar"));
  for (Choice* choice : {right_, left_, byLengths_, byBasalTurn_}) {
    // Tab stops at the chosen one; the arrow keys choose another
    choice->setFocusPolicy(Qt::NoFocus);
    connect(choice, &QAbstractButton::toggled, choice,
            [choice](bool isOn) { choice->setFocusPolicy(isOn ? Qt::TabFocus : Qt::NoFocus); });
  }
  auto* ears = new QButtonGroup(this);
  ears->addButton(right_);
  ears->addButton(left_);
  auto* measures = new QButtonGroup(this);
  measures->addButton(byBasalTurn_);
  measures->addButton(byLengths_);
  numbers_->addWidget(addBasalTurn());
  numbers_->addWidget(addLengths());

  back_->setObjectName(QStringLiteral("leavePatientButton"));
  use_->setObjectName(QStringLiteral("usePatientButton"));
  use_->setProperty("primary", true);
  for (QPushButton* button : {back_, use_}) {
    button->setFont(typeface(13, QFont::Medium));
    button->setFixedHeight(sized(32));
  }
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addWidget(title_);
  column->addWidget(heading(tr("PATIENT"), form));
  column->addWidget(label_);
  column->addWidget(labelError_);
  column->addWidget(heading(tr("EAR"), form));
  column->addLayout(sideBySide(right_, left_));
  column->addWidget(heading(tr("MEASUREMENTS"), form));
  column->addLayout(sideBySide(byBasalTurn_, byLengths_));
  column->addWidget(numbers_);
  column->addWidget(warning_);
  column->addWidget(error_);
  column->addSpacing(spacing);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(back_);
  buttons->addStretch();
  buttons->addWidget(use_);
  column->addLayout(buttons);
  return form;
}

QWidget* PatientForm::addExplanations()
{
  auto* side = new QWidget(this);
  side->setMaximumWidth(sized(explanationWidth_px));
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addStretch(1);
  auto* measure = new QPushButton(tr("Measure a CT…"), side);
  measure->setObjectName(QStringLiteral("patientCtButton"));
  connect(measure, &QPushButton::clicked, this,
          [this] { Q_EMIT ctRequested(label_->text().trimmed()); });
  column->addLayout(sideBySide(heading(tr("HOW TO MEASURE IN CT"), side), measure));
  column->addWidget(landmarks_, 8);
  column->addWidget(
      text(tr("Cochlear view: the oblique plane through the basal turn, perpendicular "
              "to the modiolus (Xu et al. 2000; Escudé et al. 2006; coordinates as "
              "in Verbist et al. 2010)."),
           11, side));
  for (const QString& sentence : {measuringOfA(), measuringOfB(), measuringOfH()})
    column->addWidget(text(sentence, 11, side, false));
  column->addWidget(heading(tr("COMPUTED FROM THE MEASUREMENTS"), side));
  column->addWidget(derived_);
  column->addStretch(1);
  return side;
}

QWidget* PatientForm::addBasalTurn()
{
  auto* page = new QWidget(numbers_);
  a_ =
      new PopulationField(tr("A: basal-turn diameter"), "aValue", lengthAPopulation(), false, page);
  b_ = new PopulationField(tr("B: basal-turn width, perpendicular to A"), "bValue",
                           widthBPopulation(), false, page);
  h_ = new PopulationField(tr("H: cochlear height (optional)"), "hValue", heightHPopulation(), true,
                           page);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  for (PopulationField* field : {a_, b_, h_}) column->addWidget(field);
  column->addStretch();
  return page;
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
  column->addWidget(text(notInClinicalCt(), 11, page));
  for (PopulationField* field : {length_, width_, height_}) column->addWidget(field);
  column->addStretch();
  return page;
}

void PatientForm::connectFields()
{
  for (PopulationField* field : {a_, b_, h_, length_, width_, height_}) {
    connect(field, &PopulationField::changed, this, &PatientForm::showState);
    connect(field, &PopulationField::submitted, this, &PatientForm::submit);
  }
  using Landmark = LandmarkDrawing::Landmark;
  for (const auto& [field, landmark] :
       {std::pair{a_, Landmark::a}, std::pair{b_, Landmark::b}, std::pair{h_, Landmark::h}})
    connect(field, &PopulationField::focused, this, [this, shown = landmark](bool isFocused) {
      landmarks_->emphasize(isFocused ? shown : Landmark::none);
    });
  connect(byBasalTurn_, &QAbstractButton::toggled, this, [this](bool isOn) {
    numbers_->setCurrentIndex(isOn ? 0 : 1);
    showState();
  });
  connect(left_, &QAbstractButton::toggled, this, &PatientForm::showState);
  connect(label_, &QLineEdit::textChanged, this, &PatientForm::showState);
  connect(label_, &QLineEdit::returnPressed, this, &PatientForm::submit);
  connect(back_, &QPushButton::clicked, this, &PatientForm::leaveRequested);
  connect(use_, &QPushButton::clicked, this, &PatientForm::submit);
}

void PatientForm::setTabOrders()
{
  QWidget* const order[] = {label_,
                            right_,
                            left_,
                            a_->input(),
                            b_->input(),
                            h_->input(),
                            length_->input(),
                            width_->input(),
                            height_->input(),
                            byBasalTurn_,
                            byLengths_,
                            use_,
                            back_};
  const auto setChoicePolicy = [this](Qt::FocusPolicy policy) {
    for (Choice* choice : {right_, left_, byBasalTurn_, byLengths_}) choice->setFocusPolicy(policy);
  };
  setChoicePolicy(Qt::TabFocus);  // others have no place in the order
  for (std::size_t i = 1; i < std::size(order); ++i) setTabOrder(order[i - 1], order[i]);
  setChoicePolicy(Qt::NoFocus);
  setFocusProxy(label_);
}

void PatientForm::beginNew()
{
  edited_.reset();
  shown_ = {};
  title_->setText(tr("New patient"));
  use_->setText(tr("Build cochlea"));
  label_->clear();
  right_->setChecked(true);
  byBasalTurn_->setChecked(true);
  for (PopulationField* field : {a_, b_, h_, length_, width_, height_})
    field->setValue(std::nullopt);
  showError({});
  showState();
}

void PatientForm::beginEditing(const anatomy::Patient& patient, const std::filesystem::path& file)
{
  beginNew();
  edited_ = file;
  title_->setText(tr("Patient measurements"));
  use_->setText(tr("Save changes"));
  setPatient(patient);
}

void PatientForm::setPatient(const anatomy::Patient& patient)
{
  shown_ = patient;
  label_->setText(QString::fromStdString(patient.label));
  (patient.side == anatomy::Side::left ? left_ : right_)->setChecked(true);
  (patient.basalTurn ? byBasalTurn_ : byLengths_)->setChecked(true);
  if (const auto& turn = patient.basalTurn) {
    a_->setValue(turn->a);
    b_->setValue(turn->b);
    h_->setValue(turn->h);
  } else {
    length_->setValue(patient.scalaTympaniLength);
    width_->setValue(patient.roundWindowWidth);
    height_->setValue(patient.roundWindowHeight);
  }
}

anatomy::Patient PatientForm::patient() const
{
  anatomy::Patient patient;
  patient.label = label_->text().trimmed().toStdString();
  patient.side = left_->isChecked() ? anatomy::Side::left : anatomy::Side::right;
  if (byBasalTurn_->isChecked()) {
    patient.basalTurn = anatomy::BasalTurn{a_->value().value_or(Length{}),
                                           b_->value().value_or(Length{}), h_->value()};
    return withMeasuresOf(shown_, patient);
  }
  patient.scalaTympaniLength = length_->value().value_or(Length{});
  patient.roundWindowWidth = width_->value().value_or(Length{});
  patient.roundWindowHeight = height_->value().value_or(Length{});
  return patient;
}

void PatientForm::showError(const QString& sentence) { showMessage(*error_, sentence); }

std::vector<PopulationField*> PatientForm::fields() const
{
  if (byBasalTurn_->isChecked()) return {a_, b_, h_};
  return {length_, width_, height_};
}

bool PatientForm::isComplete() const
{
  const auto asked = fields();
  return std::all_of(asked.begin(), asked.end(),
                     [](const PopulationField* field) { return field->isAcceptable(); });
}

void PatientForm::showState()
{
  const std::string code = label_->text().trimmed().toStdString();
  const auto checked = anatomy::checkPatientCode(code);
  showMessage(*labelError_,
              code.empty() || checked ? QString() : dataText(checked.error().message));
  use_->setEnabled(isComplete() && checked);
  const anatomy::Patient given = patient();
  landmarks_->setVisible(byBasalTurn_->isChecked());
  using Errors = std::optional<Length>;
  a_->setMeasuringError(given.errors ? Errors(given.errors->a) : Errors());
  b_->setMeasuringError(given.errors ? Errors(given.errors->b) : Errors());
  h_->setMeasuringError(given.errors ? given.errors->h : Errors());
  showMessage(*warning_, {});
  if (!isComplete()) {
    landmarks_->show({anatomy::spreadOfA().mean, anatomy::spreadOfB().mean, std::nullopt},
                     given.side);
    return derived_->showNone({});
  }
  // each alone is marked beside its field
  if (given.basalTurn && !a_->isUnusual() && !b_->isUnusual())
    for (const Sentence& sentence : anatomy::unusualMeasures(given))
      showMessage(*warning_, dataText(sentence));
  if (given.basalTurn) landmarks_->show(*given.basalTurn, given.side);
  if (array_) derived_->show({sourceScaledBy(measuresOf(given)), given, millimeters(1)}, *array_);
}

void PatientForm::submit()
{
  if (use_->isEnabled()) return patientGiven(patient());
  // to what is missing
  if (!anatomy::checkPatientCode(label_->text().trimmed().toStdString())) return label_->setFocus();
  for (PopulationField* field : fields())
    if (!field->isAcceptable()) return field->input()->setFocus();
}

}  // namespace perilymph::gui
