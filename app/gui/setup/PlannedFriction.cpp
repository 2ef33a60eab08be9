// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PlannedFriction.h"

#include <QCoreApplication>
#include <filesystem>

namespace perilymph::gui {

QString plannedFriction(const planning::PlanRequest& request)
{
  if (request.friction == lowFriction)
    return QCoreApplication::translate("perilymph::gui", "low friction, chosen");
  if (request.friction)
    return QCoreApplication::translate("perilymph::gui", "friction %1")
        .arg(QString::fromStdString(*request.friction));
  if (request.scenario == planning::PlanRequest{}.scenario)
    return QCoreApplication::translate("perilymph::gui", "friction of a tissue simulant");
  return QCoreApplication::translate("perilymph::gui", "friction of %1")
      .arg(QString::fromStdString(std::filesystem::path(request.scenario).stem().string()));
}

}  // namespace perilymph::gui
