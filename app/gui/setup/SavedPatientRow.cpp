// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/SavedPatientRow.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/setup/EnteredMeasures.h"
#include "gui/setup/VersionQuestion.h"
#include "gui/text/DataText.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr std::size_t maxListed = 8;
constexpr auto none = "none";
constexpr auto all = "all";
constexpr auto fresh = "new";

bool haveSameNumbers(const anatomy::Patient& one, const anatomy::Patient& other)
{
  if (one.basalTurn.has_value() != other.basalTurn.has_value()) return false;
  if (one.basalTurn)
    return one.basalTurn->a == other.basalTurn->a && one.basalTurn->b == other.basalTurn->b &&
           one.basalTurn->h == other.basalTurn->h;
  return one.scalaTympaniLength == other.scalaTympaniLength &&
         one.roundWindowWidth == other.roundWindowWidth &&
         one.roundWindowHeight == other.roundWindowHeight;
}

/// Labels of scenarios without a patient of the user.
bool isNoPatient(const std::string& label) { return label == "published" || label == "unnamed"; }

}  // namespace

SavedPatientRow::SavedPatientRow(QWidget* parent)
    : QWidget(parent),
      list_(new Selector("savedPatients", tr("Saved patients"), this)),
      save_(new QPushButton(this)),
      question_(new VersionQuestion(this, QStringLiteral("panel-"))),
      status_(new QLabel(this))
{
  save_->setObjectName(QStringLiteral("savePatientButton"));
  save_->setProperty("small", true);
  save_->setFont(typeface(11));
  save_->setFixedHeight(sized(22));
  save_->setFocusPolicy(Qt::TabFocus);
  status_->setObjectName(QStringLiteral("savedPatientStatus"));
  status_->setFont(typeface(11));
  status_->setProperty("quiet", true);
  status_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(list_);
  column->addWidget(save_);
  column->addWidget(question_);
  column->addWidget(status_);
  connect(list_, &Selector::chosen, this, &SavedPatientRow::choose);
  connect(save_, &QPushButton::clicked, this, &SavedPatientRow::askToSave);
  connect(question_, &VersionQuestion::otherCodeWanted, this, &SavedPatientRow::otherCodeWanted);
}

void SavedPatientRow::show(const Setup& setup)
{
  const session::Scenario& scenario = setup.scenario;
  patient_ = scenario.patient();
  isScaled_ = isScaledBy(scenario.anatomy(), patient_) && !isNoPatient(patient_.label);
  saved_ = isScaled_ ? findSavedPatient(patient_.label, patient_.side) : std::nullopt;

  const QSignalBlocker isSilent(list_);
  list_->clear();
  const auto patients = savedPatients();
  if (!saved_)
    list_->addChoice(isScaled_ ? tr("Not saved") : tr("Open a patient"), QLatin1String(none));
  for (std::size_t i = 0; i < std::min(patients.size(), maxListed); ++i)
    list_->addChoice(nameOfPatient(patients[i].patient),
                     QString::fromStdString(patients[i].file.string()),
                     numbersOfPatient(patients[i].patient));
  if (!patients.empty()) list_->addChoice(tr("Search all patients…"), QLatin1String(all));
  list_->addChoice(tr("New patient…"), QLatin1String(fresh));
  shown_ = saved_ ? QString::fromStdString(saved_->file.string()) : QString(QLatin1String(none));
  list_->show(shown_, nameOfPatient(patient_));
  question_->drop();
  const bool isChanged = saved_ && !haveSameNumbers(saved_->patient, patient_);
  status_->setProperty("error", isChanged);
  status_->setText(isChanged ? tr("Saved: %1").arg(numbersOfPatient(saved_->patient)) : QString());
  showState();
}

void SavedPatientRow::showState()
{
  const bool isChanged = saved_ && !haveSameNumbers(saved_->patient, patient_);
  save_->setVisible(isScaled_ && (!saved_ || isChanged));
  save_->setText(saved_ ? tr("Save changes") : tr("Save patient"));
  save_->setToolTip(
      saved_ ? tr("Saves these numbers as a new version of %1.").arg(nameOfPatient(patient_))
             : tr("Keeps these numbers under the patient code."));
  status_->setVisible(!status_->text().isEmpty());
}

void SavedPatientRow::choose(const QString& value)
{
  list_->show(shown_, {});  // until the choice has taken effect
  if (value == QLatin1String(all)) return allPatientsRequested();
  if (value == QLatin1String(fresh)) return newPatientRequested();
  if (value == QLatin1String(none)) return;
  const std::filesystem::path file = value.toStdString();
  const auto patient = anatomy::loadPatient(file);
  status_->setProperty("error", !patient);
  if (!patient) {
    status_->setText(dataText(patient.error().message));
    return showState();
  }
  markUsed(file);
  Q_EMIT patientChosen(*patient);
}

void SavedPatientRow::askToSave()
{
  if (!saved_) return save(patient_);
  const anatomy::Patient merged = withMeasuresOf(saved_->patient, patient_);
  question_->ask(saved_, merged, {}, [this, merged] { save(merged); });
}

void SavedPatientRow::save(const anatomy::Patient& patient)
{
  const auto file =
      savePatientInLibrary(patient, saved_ ? std::optional(saved_->file) : std::nullopt);
  const QString sentence =
      file ? tr("Saved as %1.").arg(nameOfPatient(patient_)) : dataText(file.error().message);
  if (file) saved_ = findSavedPatient(patient.label, patient.side);
  status_->setProperty("error", !file);
  status_->style()->unpolish(status_);
  status_->style()->polish(status_);
  status_->setText(sentence);
  showState();
}

}  // namespace perilymph::gui
