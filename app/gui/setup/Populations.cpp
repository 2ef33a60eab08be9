// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/Populations.h"

#include <QCoreApplication>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/Population.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

Population populationOf(const anatomy::Spread& spread)
{
  return {spread.low,
          spread.high,
          spread.mean,
          spread.standardDeviation,
          tr("138 cochleae (Pietsch et al. 2017, Sci Rep)."),
          {},
          {}};
}

QString sectionSource(const QString& mean)
{
  return tr("Mean %1 mm, n = 15 (Froehlich et al. 2024); cross-sections vary by 9–15 % (Avci et "
            "al. 2014).")
      .arg(mean);
}

}  // namespace

Population scalaLengthPopulation()
{
  const anatomy::PatientLimits limits = anatomy::patientLimits();
  return {
      limits.lengthLow,
      limits.lengthHigh,
      millimeters(33.13),
      millimeters(2.11),
      tr("Organ of Corti: 33.13 mm, SD 2.11, n = 9 (Stakhovskaya et al. 2007). The published model "
         "uses 35.58 mm."),
      notInClinicalCt(),
      {}};
}

Population windowWidthPopulation()
{
  const anatomy::PatientLimits limits = anatomy::patientLimits();
  return {limits.widthLow,
          limits.widthHigh,
          millimeters(1.94),
          millimeters(0.23),
          sectionSource(QStringLiteral("1.94")),
          notInClinicalCt(),
          {}};
}

Population windowHeightPopulation()
{
  const anatomy::PatientLimits limits = anatomy::patientLimits();
  return {limits.heightLow,
          limits.heightHigh,
          millimeters(1.85),
          millimeters(0.22),
          sectionSource(QStringLiteral("1.85")),
          notInClinicalCt(),
          {}};
}

Population lengthAPopulation()
{
  Population a = populationOf(anatomy::spreadOfA());
  a.measuring = measuringOfA();
  a.belowLow =
      tr("Smaller cochleae are more than 4 SD below the mean of 138: hypoplastic or "
         "malformed, which this model does not describe.");
  return a;
}

Population widthBPopulation()
{
  Population b = populationOf(anatomy::spreadOfB());
  b.measuring = measuringOfB();
  return b;
}

Population heightHPopulation()
{
  const anatomy::Spread h = anatomy::limitsOfH();
  return {h.low,
          h.high,
          std::nullopt,
          std::nullopt,
          tr("Definitions of H vary between publications; only limits are given."),
          measuringOfH(),
          {}};
}

QString measuringOfA()
{
  return tr(
      "A: in the cochlear view, from the center of the round window through the modiolus to "
      "the far lateral wall.");
}

QString measuringOfB()
{
  return tr(
      "B: in the same view, perpendicular to A through the modiolus, from lateral wall to "
      "lateral wall.");
}

QString measuringOfH()
{
  return tr(
      "H: in the view perpendicular to the cochlear view, along the modiolar axis from the "
      "base to the apex.");
}

QString notInClinicalCt() { return tr("Not visible in clinical CT; from micro-CT or histology."); }

}  // namespace perilymph::gui
