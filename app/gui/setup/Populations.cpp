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
  return {spread.low, spread.high, spread.mean, spread.standardDeviation,
          tr("138 cochleae (Pietsch et al. 2017, Sci Rep).")};
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
  return {limits.lengthLow, limits.lengthHigh, millimeters(33.13), millimeters(2.11),
          tr("Organ of Corti: 33.13 ± 2.11 mm, n = 9 (Stakhovskaya et al. 2007). The published "
             "model uses 35.58 mm.")};
}

Population windowWidthPopulation()
{
  const anatomy::PatientLimits limits = anatomy::patientLimits();
  return {limits.widthLow, limits.widthHigh, millimeters(1.94), millimeters(0.23),
          sectionSource(QStringLiteral("1.94"))};
}

Population windowHeightPopulation()
{
  const anatomy::PatientLimits limits = anatomy::patientLimits();
  return {limits.heightLow, limits.heightHigh, millimeters(1.85), millimeters(0.22),
          sectionSource(QStringLiteral("1.85"))};
}

Population lengthAPopulation() { return populationOf(anatomy::spreadOfA()); }

Population widthBPopulation() { return populationOf(anatomy::spreadOfB()); }

Population heightHPopulation()
{
  const anatomy::Spread h = anatomy::limitsOfH();
  return {h.low, h.high, std::nullopt, std::nullopt,
          tr("Definitions of H vary between publications; only limits are given.")};
}

}  // namespace perilymph::gui
