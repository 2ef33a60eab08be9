// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/PlanReportContent.h"

#include <QCoreApplication>
#include <cmath>

#include "gui/setup/PlannedFriction.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString earText(anatomy::Side side)
{
  return side == anatomy::Side::left ? tr("left ear") : tr("right ear");
}

QString numberOf(const planning::Plan& plan)
{
  if (plan.seal == Seal::changed) return tr("changed by hand");
  const QString number = QString::fromStdString(plan.fingerprint);
  return plan.seal == Seal::absent ? tr("%1, no seal").arg(number) : number;
}

}  // namespace

QString PlanReportContent::code() const
{
  const std::string& label = plan().request.patient.label;
  return anatomy::checkPatientCode(label) ? QString::fromStdString(label) : QStringLiteral("–");
}

QString PlanReportContent::ear() const { return earText(plan().request.patient.side); }

ReportIdentity PlanReportContent::identity() const
{
  const anatomy::Patient& patient = plan().request.patient;
  const bool isVouchedFor = plan().seal == Seal::intact && patient.seal == Seal::intact;
  return {"Insertion plan", codeOf(patient),
          isVouchedFor ? patient.origin.seriesKey : std::string()};
}

QString PlanReportContent::number() const { return numberOf(plan()); }

QColor inkOfArray(std::size_t place)
{
  return colorOf(figures::ink::arrays[place % figures::ink::arrays.size()]);
}

QString numberedName(const planning::ArrayPlan& array, std::size_t place)
{
  const QString name = QString::fromStdString(array.name).section(QStringLiteral(" ("), 0, 0);
  return QStringLiteral("%1  %2").arg(place + 1).arg(name);
}

QString medianText(const planning::Band& band, int decimals)
{
  return QStringLiteral("%1 (%2–%3)")
      .arg(numberText(band.median, decimals), numberText(band.low, decimals),
           numberText(band.high, decimals));
}

QString chanceText(const analysis::Estimate& estimate, std::size_t draws)
{
  if (!std::isfinite(estimate.value) || analysis::countedOf(estimate, draws))
    return shownShare(estimate, draws);
  return QStringLiteral("%1 (%2–%3)")
      .arg(numberText(100.0 * estimate.value, 0), numberText(100.0 * estimate.low, 0),
           numberText(100.0 * estimate.high, 0));
}

Result<PlanReportContent> planReportContent(planning::StoredPlan stored)
{
  PlanReportContent content;
  content.stored = std::move(stored);
  const auto scenario = session::loadScenario(content.plan().request.scenario);
  if (!scenario) return scenario.error();
  anatomy::Cochlea cochlea = scenario->parameters().cochlea;
  cochlea.source = anatomy::AnatomySource::mean;
  cochlea.patient = content.plan().request.patient;
  const auto built = anatomy::buildAnatomy(cochlea, content.code().toStdString());
  if (!built) return built.error();
  content.anatomy = *built;
  content.measures = analysis::measure(*content.anatomy, cochlea);
  const auto bands = analysis::errorBands(cochlea, content.measures);
  if (bands) content.bands = *bands;
  return content;
}

}  // namespace perilymph::gui
