// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PlannedFriction.h"

#include <QCoreApplication>
#include <filesystem>

namespace perilymph::gui {

namespace {

/// The name of a shipped file as it is, that of another one without its folder.
QString nameOf(const std::string& nameOrFile)
{
  return QString::fromStdString(std::filesystem::path(nameOrFile).stem().string());
}

}  // namespace

QString plannedFriction(const planning::PlanRequest& request)
{
  if (request.friction == lowFriction)
    return QCoreApplication::translate("perilymph::gui", "low friction, chosen");
  if (request.friction)
    return QCoreApplication::translate("perilymph::gui", "friction %1")
        .arg(nameOf(*request.friction));
  if (request.scenario == planning::PlanRequest{}.scenario)
    return QCoreApplication::translate("perilymph::gui", "friction of a tissue simulant");
  return QCoreApplication::translate("perilymph::gui", "friction of %1")
      .arg(nameOf(request.scenario));
}

}  // namespace perilymph::gui
