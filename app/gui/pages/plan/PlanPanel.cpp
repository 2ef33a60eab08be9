// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanPanel.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/run/UserSettings.h"
#include "gui/setup/Catalog.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PlannedFriction.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/validation/ClinicalPrediction.h"

namespace perilymph::gui {

namespace {

constexpr int panelWidth_px = 264;
constexpr int drawCounts[] = {16, 32, 64, 128, 256};
constexpr int usualDraws = 64;

/// Saved patients with A and B.
std::vector<anatomy::Patient> ownPatients()
{
  std::vector<anatomy::Patient> patients;
  for (const SavedPatient& each : savedPatients())
    if (each.patient.basalTurn) patients.push_back(each.patient);
  return patients;
}

/// Shipped patients with A and B.
std::vector<anatomy::Patient> examples()
{
  std::vector<anatomy::Patient> patients;
  for (const std::string& name : shippedNames("resources/patients")) {
    const auto file = findByName("patient", "resources/patients", name);
    if (!file) continue;
    const auto patient = anatomy::loadPatient(*file);
    if (patient && patient->basalTurn) patients.push_back(*patient);
  }
  return patients;
}

QString keyOf(const anatomy::Patient& patient)
{
  return QString::fromStdString(anatomy::patientText(patient));
}

/// With a capital, as the other entries of lists.
QString inTheList(const QString& words) { return words.left(1).toUpper() + words.mid(1); }

const QString lastArraysKey = QStringLiteral("plan/arrays");

/// Arrays that are planned unless others are chosen: those of the last plan, and before the first those
/// with published angular depths.
bool isUsual(const std::string& array)
{
  const QStringList last = UserSettings().value(lastArraysKey).toStringList();
  if (!last.isEmpty()) return last.contains(QString::fromStdString(array));
  return std::find(std::begin(validation::clinicalArrays), std::end(validation::clinicalArrays),
                   array) != std::end(validation::clinicalArrays);
}

}  // namespace

PlanPanel::PlanPanel(QWidget* parent)
    : QWidget(parent),
      patientList_(new Selector("planPatientSelector", tr("Patient"), this)),
      planList_(new Selector("planSelector", tr("Saved plans"), this)),
      friction_(new Selector("planFriction", tr("Friction"), this)),
      draws_(new Selector("planDraws", tr("Simulations, at most"), this)),
      compute_(rowButton(tr("Compute"), "computePlanButton", this)),
      cancel_(rowButton(tr("Cancel"), "cancelPlanButton", this)),
      progress_(new QProgressBar(this))
{
  setFixedWidth(sized(panelWidth_px));
  auto* content = new QWidget(this);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, spacing);
  column->setSpacing(spacing);
  addPatient(*column);
  addPlans(*column);
  addArrays(*column);
  column->addStretch();
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(2 * spacing, spacing, 2 * spacing, 2 * spacing);
  foot->setSpacing(spacing);
  addFoot(*foot);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  whole->addWidget(verticalScroll(content, this), 1);
  whole->addLayout(foot);
  showProgress(std::nullopt);
  refresh();
}

void PlanPanel::addPatient(QVBoxLayout& column)
{
  column.addWidget(panelHeading(tr("PATIENT"), this));
  column.addWidget(patientList_);
  connect(patientList_, &Selector::chosen, this, &PlanPanel::choosePatient);
}

void PlanPanel::addPlans(QVBoxLayout& column)
{
  column.addWidget(panelHeading(tr("SAVED PLANS"), this));
  column.addWidget(planList_);
  connect(planList_, &Selector::chosen, this, [this](const QString& folder) {
    const auto found = std::find_if(plans_.begin(), plans_.end(), [&](const StoredPlan& each) {
      return folder == QString::fromStdString(each.folder.string());
    });
    if (found == plans_.end()) return;
    const StoredPlan chosen = *found;  // the list is read again meanwhile
    Q_EMIT planChosen(chosen);
  });
}

void PlanPanel::addArrays(QVBoxLayout& column)
{
  column.addWidget(panelHeading(tr("ARRAYS"), this));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(spacing);
  auto* all = rowButton(tr("All"), "planAllArraysButton", this);
  auto* none = rowButton(tr("None"), "planNoArraysButton", this);
  all->setAccessibleName(tr("Choose all arrays"));
  none->setAccessibleName(tr("Choose no array"));
  buttons->addWidget(all);
  buttons->addWidget(none);
  column.addLayout(buttons);
  connect(all, &QPushButton::clicked, this, [this] { check(true); });
  connect(none, &QPushButton::clicked, this, [this] { check(false); });
  QString maker;
  for (const CatalogArray& each : catalogArrays()) {
    if (each.maker != maker) column.addWidget(panelHeading(maker = each.maker, this));
    auto* box = new CheckBox(each.title, this);
    box->setObjectName(QStringLiteral("plan-array-%1").arg(each.name));
    box->setToolTip(each.summary);
    box->setChecked(isUsual(each.name.toStdString()));
    connect(box, &QAbstractButton::toggled, this, &PlanPanel::showState);
    column.addWidget(box);
    arrays_.push_back({box, each.name.toStdString()});
  }
}

void PlanPanel::addFoot(QVBoxLayout& column)
{
  friction_->addChoice(inTheList(plannedFriction(planning::PlanRequest{})), QString());
  for (const char* other : {endosteumFriction, simulantFriction}) {
    planning::PlanRequest named;
    named.friction = other;
    friction_->addChoice(inTheList(plannedFriction(named)), QString::fromUtf8(other));
  }
  friction_->setToolTip(tr(
      "No friction in a living ear is known. The first one is estimated from force curves in fresh "
      "cochleae of pigs, median 0.165; simulations take it from 0.08 to 0.33. 0.12 is recalled for "
      "arrays on endosteum; with the friction measured on a tissue simulant arrays stop at 240 to "
      "350°."));
  column.addWidget(friction_);
  for (const int count : drawCounts)
    draws_->addChoice(tr("%1 simulations at most").arg(count), QString::number(count));
  draws_->show(QString::number(usualDraws), {});
  draws_->setToolTip(
      tr("A simulation has a cochlea within the errors of the measures, an approach, a stiffness "
         "and a "
         "surgeon. Fewer are run if the median angle is known to 5° and the median peak force to "
         "5 %."));
  column.addWidget(draws_);
  compute_->setProperty("primary", true);
  cancel_->setToolTip(tr("Esc. What is done is kept, and Compute continues there."));
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  progress_->setRange(0, 1000);
  column.addWidget(progress_);
  column.addWidget(compute_);
  column.addWidget(cancel_);
  connect(compute_, &QPushButton::clicked, this, [this] {
    QStringList arrays;
    for (const std::string& array : request().arrays) arrays << QString::fromStdString(array);
    UserSettings().setValue(lastArraysKey, arrays);
    Q_EMIT computeRequested();
  });
  connect(cancel_, &QPushButton::clicked, this, &PlanPanel::cancelRequested);
}

void PlanPanel::refresh()
{
  const std::optional<anatomy::Patient> before = patient_;
  patients_ = ownPatients();
  const std::size_t own = patients_.size();
  for (anatomy::Patient& each : examples()) patients_.push_back(std::move(each));
  patientList_->clear();
  for (std::size_t i = 0; i < patients_.size(); ++i) {
    const QString name = nameOfPatient(patients_[i]);
    patientList_->addChoice(i < own ? name : tr("Example: %1").arg(name), keyOf(patients_[i]),
                            numbersOfPatient(patients_[i]));
  }
  if (before) return setPatient(*before);
  if (own > 0) return setPatient(patients_.front());
  patientList_->show({}, tr("Choose a patient"));
  showState();
}

void PlanPanel::setPatient(const anatomy::Patient& patient)
{
  const QString key = keyOf(patient);
  if (patientList_->findData(key) < 0) {
    patients_.push_back(patient);
    patientList_->addChoice(nameOfPatient(patient), key, numbersOfPatient(patient));
  }
  patientList_->show(key, {});
  patient_ = patient;
  listPlans();
  showState();
}

void PlanPanel::choosePatient(const QString& key)
{
  const auto found = std::find_if(patients_.begin(), patients_.end(),
                                  [&key](const auto& each) { return keyOf(each) == key; });
  if (found == patients_.end()) return;
  const anatomy::Patient patient = *found;
  setPatient(patient);
  Q_EMIT patientChosen();
}

void PlanPanel::listPlans()
{
  const QString before = planList_->value();
  plans_ = storedPlans();
  std::erase_if(plans_, [this](const StoredPlan& each) {
    return each.request.patient.label != patient_->label ||
           each.request.patient.side != patient_->side;
  });
  planList_->clear();
  planList_->addChoice(plans_.empty() ? tr("none yet") : tr("choose a plan"), QString());
  for (const StoredPlan& each : plans_) {
    const auto utc = QDateTime::fromString(QString::fromStdString(each.madeUtc), Qt::ISODate);
    const QString when = utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    QString arrays = each.request.arrays.size() == 1
                         ? tr("1 array")
                         : tr("%1 arrays").arg(each.request.arrays.size());
    if (each.request.friction) arrays += QStringLiteral(", ") + plannedFriction(each.request);
    const bool isRunning = isBusy_ && each.folder == folderOfPlan(request());
    planList_->addChoice(each.isComplete ? tr("%1 · %2").arg(when, arrays)
                         : isRunning     ? tr("%1 · %2 · being computed").arg(when, arrays)
                                         : tr("%1 · %2 · interrupted").arg(when, arrays),
                         QString::fromStdString(each.folder.string()),
                         QString::fromStdString(each.folder.string()));
  }
  planList_->show(planList_->findData(before) >= 0 ? before : QString(), {});
  planList_->setEnabled(!plans_.empty() && !isBusy_);
}

planning::PlanRequest PlanPanel::request() const
{
  planning::PlanRequest request;
  if (patient_) request.patient = *patient_;
  for (const Row& row : arrays_)
    if (row.box->isChecked()) request.arrays.push_back(row.array);
  if (const QString friction = friction_->value(); !friction.isEmpty())
    request.friction = friction.toStdString();
  request.draws = draws_->value().toUInt();
  return request;
}

void PlanPanel::showPlan(const StoredPlan& plan)
{
  setPatient(plan.request.patient);
  const std::vector<std::string>& arrays = plan.request.arrays;
  for (const Row& row : arrays_)
    row.box->setChecked(std::find(arrays.begin(), arrays.end(), row.array) != arrays.end());
  const QString friction = QString::fromStdString(plan.request.friction.value_or(""));
  friction_->show(friction, inTheList(plannedFriction(plan.request)));
  draws_->show(QString::number(plan.request.draws),
               tr("%1 simulations at most").arg(plan.request.draws));
  const QString folder = QString::fromStdString(plan.folder.string());
  if (planList_->findData(folder) >= 0) planList_->show(folder, {});
}

void PlanPanel::check(bool isChecked)
{
  for (const Row& row : arrays_) row.box->setChecked(isChecked);
}

void PlanPanel::compute() { compute_->click(); }

void PlanPanel::showProgress(std::optional<double> fraction)
{
  isBusy_ = fraction.has_value();
  progress_->setVisible(isBusy_);
  progress_->setValue(int(1000.0 * fraction.value_or(0.0)));
  showState();
}

void PlanPanel::showState()
{
  const bool hasArray = std::any_of(arrays_.begin(), arrays_.end(),
                                    [](const Row& row) { return row.box->isChecked(); });
  compute_->setVisible(!isBusy_);
  cancel_->setVisible(isBusy_);
  compute_->setEnabled(patient_ && hasArray);
  compute_->setToolTip(!patient_  ? tr("Choose a patient with A and B first.")
                       : hasArray ? QString()
                                  : tr("Choose an array first."));
  Q_EMIT readyChanged(compute_->isEnabled() && !isBusy_);
  for (Selector* field : {patientList_, friction_, draws_}) field->setEnabled(!isBusy_);
  planList_->setEnabled(!isBusy_ && !plans_.empty());
  for (const Row& row : arrays_) row.box->setEnabled(!isBusy_);
}

}  // namespace perilymph::gui
