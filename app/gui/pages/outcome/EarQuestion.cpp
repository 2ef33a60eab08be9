// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcome/EarQuestion.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/setup/MeasureVersions.h"
#include "gui/text/DataText.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/imaging/MeasuredPatient.h"

namespace perilymph::gui {

namespace {

constexpr int question_px = 460;

bool hasSeries(const session::PatientRecord& record, const std::string& series)
{
  return std::ranges::any_of(record.scans,
                             [&](const auto& each) { return each.series == series; }) ||
         std::ranges::any_of(record.outcomes,
                             [&](const auto& each) { return each.series == series; });
}

}  // namespace

QStringList earDoubts(const SavedPatient& patient, const outcome::Ear& ear,
                      const ct::CtProvenance& ct)
{
  const std::string& series = ct.seriesKey;
  QStringList doubts;
  const QString code = QString::fromStdString(patient.patient.label);
  const auto sideText = [](anatomy::Side side) {
    return side == anatomy::Side::left ? EarQuestion::tr("left") : EarQuestion::tr("right");
  };
  const anatomy::Side side = patient.patient.side;
  if (ear.measures.side != side)
    doubts << EarQuestion::tr("The ear in this CT is a %1 one, that of %2 a %3 one.")
                  .arg(sideText(ear.measures.side), code, sideText(side));
  if (ct.side && *ct.side != side)
    doubts << EarQuestion::tr("The images state a %1 ear (Laterality); that of %2 is a %3 one.")
                  .arg(sideText(*ct.side), code, sideText(side));
  const ComparedMeasures saved = comparedOf(patient.patient);
  const ComparedMeasures here = comparedOf(imaging::measuredPatient(ear.measures));
  constexpr std::size_t asked = 2;  // A and B
  for (std::size_t k = 0; k < asked; ++k)
    if (differenceOf(saved[k], here[k], k).isBeyond)
      doubts << EarQuestion::tr("%1 is %2 mm in this CT, %3 mm in the record (95 %).")
                    .arg(comparedNames()[k], comparedText(here[k], k), comparedText(saved[k], k));
  if (std::ranges::find(ear.flags, outcome::Flag::registrationPoor) != ear.flags.end())
    doubts << EarQuestion::tr(
        "The CT before surgery and this one do not agree around the cochlea.");
  if (doubts.isEmpty() &&
      std::ranges::find(ear.flags, outcome::Flag::anotherEar) != ear.flags.end())
    doubts << dataText(outcome::sentenceOf(outcome::Flag::anotherEar));
  for (const SavedPatient& each : savedPatients())
    if (each.patient.label != patient.patient.label && !series.empty() &&
        hasSeries(each.record, series))
      doubts << EarQuestion::tr("This CT series is in the record of %1.")
                    .arg(nameOfPatient(each.patient));
  return doubts;
}

EarQuestion::EarQuestion(const QString& patient, const QStringList& doubts,
                         std::optional<anatomy::Side> otherSide, QWidget* parent)
    : QDialog(parent)
{
  setObjectName(QStringLiteral("anotherEarQuestion"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Is this CT of %1?").arg(patient));
  const QString which = !otherSide ? tr("This CT may be of another person than %1.").arg(patient)
                        : *otherSide == anatomy::Side::left
                            ? tr("This CT shows a left ear; the record is that of a right ear.")
                            : tr("This CT shows a right ear; the record is that of a left ear.");
  auto* title = new WrappedLabel(which, this);
  title->setObjectName(QStringLiteral("anotherEarTitle"));
  title->setFont(typeface(13, QFont::DemiBold));
  auto* differences = new WrappedLabel(doubts.join(QLatin1Char('\n')), this);
  differences->setObjectName(QStringLiteral("anotherEarDoubts"));
  differences->setTextFormat(Qt::PlainText);
  differences->setFont(typeface(12));
  auto* what = new WrappedLabel(
      tr("If it is joined, the outcome stands in the record of %1 and in the statistics.")
          .arg(patient),
      this);
  what->setFont(typeface(12));
  what->setProperty("quiet", true);
  auto* leave = panelButton(tr("No, leave it out"), "leaveEarButton", this);
  auto* join = panelButton(tr("It is %1: join it").arg(patient), "joinEarButton", this);
  leave->setDefault(true);
  setPrimary(*leave, true);
  join->setAutoDefault(false);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(join);
  buttons->addWidget(leave);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, 2 * spacing);
  column->setSpacing(spacing);
  column->addWidget(title);
  column->addWidget(differences);
  column->addWidget(what);
  column->addLayout(buttons);
  setFixedWidth(sized(question_px));
  connect(leave, &QPushButton::clicked, this, &QDialog::reject);
  connect(join, &QPushButton::clicked, this, &QDialog::accept);
  leave->setFocus();
}

}  // namespace perilymph::gui
