// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PlannedForces.h"

#include <QCoreApplication>
#include <QDateTime>

#include "gui/setup/PlanStore.h"
#include "gui/setup/PlannedFriction.h"
#include "perilymph/planning/PlanReading.h"

namespace perilymph::gui {

PlannedForce plannedForce(const planning::Plan& plan, std::size_t array, const std::string& madeUtc)
{
  const planning::ArrayPlan& planned = plan.arrays[array];
  const auto made = QDateTime::fromString(QString::fromStdString(madeUtc), Qt::ISODate);
  PlannedForce force;
  force.name = made.isValid() ? QCoreApplication::translate("perilymph::gui", "plan of %1")
                                    .arg(made.toLocalTime().toString(QStringLiteral("yyyy-MM-dd")))
                              : QCoreApplication::translate("perilymph::gui", "plan");
  force.number = QString::fromStdString(plan.fingerprint.substr(0, 16));
  force.hold = bandsHold(plan);
  force.peak_mN = planned.peak_mN;
  force.end_mN = planned.end_mN;
  force.angle_deg = planned.angle_deg;
  if (planned.after1s_mN.high > 0.0) force.after1s_mN = planned.after1s_mN;
  force.label = QCoreApplication::translate("perilymph::gui", "plan: %1").arg(force.hold);
  if (!planned.force.empty()) {
    QString last = QCoreApplication::translate("perilymph::gui", ", at last %1 of %2")
                       .arg(planned.force.back().draws)
                       .arg(planned.draws);
    // in one line, after the comma
    last.replace(QLatin1Char(' '), QChar(QChar::Nbsp)).replace(1, 1, QLatin1Char(' '));
    force.label += last;
  }
  force.patient = plan.request.patient;
  force.approach = plan.request.approach.value_or(anatomy::Approach{});
  force.array = plan.request.arrays[array];
  for (const planning::ForceBand& each : planned.force)
    force.points.push_back(
        {each.depth_mm, each.force_mN.low, each.force_mN.median, each.force_mN.high});
  return force;
}

std::optional<PlannedForce> newestPlannedForce(const session::Scenario& scenario)
{
  for (const StoredPlan& stored : storedPlans()) {
    PlannedForce asked;
    asked.patient = stored.request.patient;
    asked.approach = stored.request.approach.value_or(anatomy::Approach{});
    for (std::size_t array = 0; array < stored.request.arrays.size(); ++array) {
      asked.array = stored.request.arrays[array];
      if (stored.shownDraws == 0 || !asked.isFor(scenario)) continue;
      auto read = planning::readPlan(stored.folder / planJsonFile);
      if (!read || array >= read->plan.arrays.size()) continue;  // the one before may be readable
      read->plan.request = stored.request;
      return plannedForce(read->plan, array, stored.madeUtc);
    }
  }
  return std::nullopt;
}

}  // namespace perilymph::gui
