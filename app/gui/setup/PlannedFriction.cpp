// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PlannedFriction.h"

#include <QCoreApplication>
#include <cmath>
#include <filesystem>

#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "perilymph/planning/PlanWords.h"

namespace perilymph::gui {

namespace {

/// The name of a shipped file as it is, that of another one without its folder.
QString nameOf(const std::string& nameOrFile)
{
  return QString::fromStdString(std::filesystem::path(nameOrFile).stem().string());
}

/// Whether a request takes the friction of the plans' usual scenario.
bool isUsual(const planning::PlanRequest& request)
{
  return !request.friction && request.scenario == planning::PlanRequest{}.scenario;
}

}  // namespace

QString plannedFriction(const planning::PlanRequest& request)
{
  if (isUsual(request) || request.friction == estimatedFriction)
    return QCoreApplication::translate("perilymph::gui", "friction estimated from pig tissue");
  if (request.friction == endosteumFriction)
    return QCoreApplication::translate("perilymph::gui", "friction of endosteum, assumed");
  if (request.friction == simulantFriction)
    return QCoreApplication::translate("perilymph::gui", "friction of a tissue simulant");
  if (request.friction)
    return QCoreApplication::translate("perilymph::gui", "friction %1")
        .arg(nameOf(*request.friction));
  return QCoreApplication::translate("perilymph::gui", "friction of %1")
      .arg(nameOf(request.scenario));
}

QString plannedFriction(const planning::Plan& plan)
{
  planning::PlanRequest request = plan.request;
  // plans of former versions took another friction by default
  if (isUsual(request) && !(plan.frictionSpread > 0.0)) request.friction = endosteumFriction;
  return plannedFriction(request);
}

QString bandsHold(const planning::Plan& plan) { return dataText(planning::bandsHold(plan)); }

QString bandsShare(const planning::Plan& plan) { return dataText(planning::bandsShare(plan)); }

QString differenceText(const planning::Band& band)
{
  const auto signedText = [](double value) {
    return (std::lround(value) > 0 ? QStringLiteral("+") : QString()) + numberText(value, 0);
  };
  return QCoreApplication::translate("perilymph::gui", "%1 (%2 to %3)")
      .arg(signedText(band.median), signedText(band.low), signedText(band.high));
}

QString shownShare(const analysis::Estimate& fraction, std::size_t draws)
{
  if (!std::isfinite(fraction.value)) return QStringLiteral("–");
  if (const auto count = analysis::countedOf(fraction, draws))
    return QCoreApplication::translate("perilymph::gui", "%1 of %2").arg(*count).arg(draws);
  return QCoreApplication::translate("perilymph::gui", "%1 %")
      .arg(numberText(100.0 * fraction.value, 0));
}

QString shownShareAndInterval(const analysis::Estimate& fraction, std::size_t draws)
{
  if (!std::isfinite(fraction.value) || analysis::countedOf(fraction, draws))
    return shownShare(fraction, draws);
  return QCoreApplication::translate("perilymph::gui", "%1 (%2–%3) %")
      .arg(numberText(100.0 * fraction.value, 0), numberText(100.0 * fraction.low, 0),
           numberText(100.0 * fraction.high, 0));
}

}  // namespace perilymph::gui
