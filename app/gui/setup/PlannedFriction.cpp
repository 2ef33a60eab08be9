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
  const bool isUsual = !request.friction && request.scenario == planning::PlanRequest{}.scenario;
  if (isUsual || request.friction == endosteumFriction)
    return QCoreApplication::translate("perilymph::gui", "friction of endosteum, chosen");
  if (request.friction == simulantFriction)
    return QCoreApplication::translate("perilymph::gui", "friction of a tissue simulant");
  if (request.friction)
    return QCoreApplication::translate("perilymph::gui", "friction %1")
        .arg(nameOf(*request.friction));
  return QCoreApplication::translate("perilymph::gui", "friction of %1")
      .arg(nameOf(request.scenario));
}

}  // namespace perilymph::gui
