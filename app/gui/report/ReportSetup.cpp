// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportSetup.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "gui/setup/Catalog.h"
#include "gui/text/LandmarkText.h"
#include "gui/text/Numbers.h"
#include "perilymph/foundation/Normal.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// A value of a scenario without quotation marks; empty if it has none.
QString valueOf(const session::Scenario& scenario, const std::string& key)
{
  for (const auto& [name, value] : scenario.values())
    if (name == key) return QString::fromStdString(value).remove(QLatin1Char('"'));
  return {};
}

/// "0.165", or what it is between speeds.
QString coefficientText(const session::Scenario& scenario)
{
  const mechanics::FrictionLaw& law = scenario.friction();
  if (!law.bySpeed.isEmpty())
    return tr("%1 to %2 by speed")
        .arg(numberText(law.bySpeed.minimum(), 2), numberText(law.bySpeed.maximum(), 2));
  return numberText(law.staticCoefficient, 3);
}

/// Names of landmarks as in the window, of those in a patient's file.
QString clinicalNames(const std::string& names)
{
  QStringList shown = QString::fromStdString(names).split(QStringLiteral(", "));
  for (QString& name : shown)
    if (const auto mark = ct::markNamed(name.toStdString())) name = markLabel(*mark);
  return shown.join(QStringLiteral(", "));
}

}  // namespace

QString frictionInEars(const session::Scenario& scenario)
{
  const double coefficient = scenario.friction().staticCoefficient;
  const session::FrictionSpread& known = scenario.parameters().frictionSpread;
  if (!known.isKnown() || !scenario.friction().bySpeed.isEmpty()) return {};
  const double factor = std::exp(halfWidth95 * std::hypot(known.shared, known.ear));
  return tr("%1 to %2 (95 %)")
      .arg(numberText(coefficient / factor, 2), numberText(coefficient * factor, 2));
}

QString frictionText(const session::Scenario& scenario, References& references)
{
  const QString name = valueOf(scenario, "friction");
  const std::vector<CatalogFriction> catalog = catalogFrictions();
  const auto found = std::ranges::find(catalog, name, &CatalogFriction::name);
  const bool isShipped = found != catalog.end();
  return tr("%1; %2 %3")
      .arg(coefficientText(scenario), isShipped ? found->title : tr("own value"),
           references.label(isShipped ? found->source.toStdString() : std::string()));
}

QString landmarksText(const ReportContent& content)
{
  if (!content.hasPatient() || !content.scenario.patient().basalTurn) return QStringLiteral("–");
  if (!content.measured) return tr("not known");
  if (!anatomy::isFromCt(*content.measured)) return tr("none; entered by hand");
  const anatomy::MeasurementOrigin& origin = content.measured->origin;
  if (origin.landmarksByHand.empty()) return tr("automatic");
  return tr("moved by hand: %1").arg(clinicalNames(origin.landmarksByHand));
}

}  // namespace perilymph::gui
