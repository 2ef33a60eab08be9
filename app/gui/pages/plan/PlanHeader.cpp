// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanHeader.h"

#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/pages/plan/PlanText.h"
#include "gui/setup/EarApproach.h"
#include "gui/setup/EnteredMeasures.h"
#include "gui/setup/MeasureVersions.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/ElidedLabel.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/analysis/ErrorBand.h"

namespace perilymph::gui {

PlanHeader::PlanHeader(QWidget* parent)
    : QWidget(parent),
      name_(new ElidedLabel(this)),
      measures_(new WrappedLabel({}, this)),
      superseded_(new WrappedLabel({}, this)),
      approach_(new WrappedLabel({}, this)),
      otherApproach_(new WrappedLabel({}, this)),
      change_(new WrappedLabel({}, this)),
      note_(new WrappedLabel({}, this))
{
  name_->setObjectName(QStringLiteral("planPatient"));
  name_->setFont(typeface(15, QFont::DemiBold));
  measures_->setObjectName(QStringLiteral("planMeasures"));
  measures_->setFont(typeface(13));
  superseded_->setObjectName(QStringLiteral("planSuperseded"));
  superseded_->setFont(typeface(13));
  superseded_->setProperty("error", true);
  approach_->setObjectName(QStringLiteral("planApproach"));
  approach_->setFont(typeface(13));
  otherApproach_->setObjectName(QStringLiteral("planOtherApproach"));
  otherApproach_->setFont(typeface(13));
  otherApproach_->setProperty("error", true);
  change_->setObjectName(QStringLiteral("planMeasureChange"));
  change_->setFont(typeface(12));
  note_->setObjectName(QStringLiteral("planNote"));
  note_->setFont(typeface(12));
  note_->setProperty("quiet", true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(name_);
  column->addWidget(measures_);
  column->addWidget(approach_);
  column->addWidget(superseded_);
  column->addWidget(otherApproach_);
  column->addWidget(change_);
  column->addWidget(note_);
}

void PlanHeader::show(const anatomy::Patient& patient)
{
  name_->setText(nameOfPatient(patient) + handChange(patient));
  superseded_->setText(supersededText(patient));
  superseded_->setVisible(!superseded_->text().isEmpty());
  change_->setText(remeasuredText(patient));
  change_->setVisible(!change_->text().isEmpty());
  if (!patient.basalTurn) return measures_->clear();
  const anatomy::BasalTurn& turn = *patient.basalTurn;
  const anatomy::BasalTurnErrors errors = analysis::errorsOf(patient);
  QStringList parts{tr("A %1").arg(measureText(turn.a, errors.a)),
                    tr("B %1").arg(measureText(turn.b, errors.b))};
  parts << (turn.h
                ? tr("H %1").arg(measureText(*turn.h, errors.h.value_or(analysis::measuringError)))
                : tr("H not measured (population mean ± SD used)"));
  const QString assumed = numberText(inMillimeters(analysis::measuringError), 1);
  QStringList entered;
  for (const std::string& each : enteredMeasures(patient)) entered << QString::fromStdString(each);
  parts << (!patient.errors ? tr("95 % intervals, errors assumed: SD %1 mm").arg(assumed)
            : entered.isEmpty()
                ? tr("95 % intervals, errors as measured")
                : tr("95 % intervals, errors as measured, that of %1 (entered) assumed: SD %2 mm")
                      .arg(entered.join(QStringLiteral(", ")), assumed));
  measures_->setText(parts.join(QStringLiteral("   ·   ")));
  QStringList unusual;
  for (const Sentence& sentence : anatomy::unusualMeasures(patient)) unusual << dataText(sentence);
  measures_->setToolTip(
      (QStringList{tr("A: basal-turn diameter; B: basal-turn width, perpendicular to A; H: height. "
                      "Every simulation takes other values within these errors.")} +
       unusual)
          .join(QLatin1Char('\n')));
}

void PlanHeader::showApproach(const anatomy::Patient& patient,
                              const std::optional<anatomy::Approach>& approach,
                              const std::optional<anatomy::Approach>& now)
{
  const anatomy::Cochlea cochlea{anatomy::AnatomySource::mean, patient};
  approach_->setVisible(approach.has_value());
  if (approach) approach_->setText(tr("Approach: %1").arg(approachText(cochlea, *approach)));
  otherApproach_->setVisible(now.has_value());
  if (now)
    otherApproach_->setText(
        tr("The line of approach in the CT is another one now: %1. Compute makes a plan with it.")
            .arg(approachText(cochlea, *now)));
}

void PlanHeader::setNote(const QString& note) { note_->setText(note); }

}  // namespace perilymph::gui
