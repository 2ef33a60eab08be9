// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/EarApproach.h"

#include <QCoreApplication>

#include "gui/run/ScenarioApproach.h"
#include "gui/text/ApproachText.h"

namespace perilymph::gui {

QString approachText(const anatomy::Cochlea& cochlea, const anatomy::Approach& approach)
{
  const bool isAlong = isAlongAxis(approach);
  const auto scala = isAlong ? Result<std::shared_ptr<const anatomy::ScalaTympani>>(nullptr)
                             : anatomy::buildAnatomy(cochlea, cochlea.patient.label);
  if (isAlong || !scala)
    return QCoreApplication::translate("perilymph::gui", "along the axis of the opening");
  return approachText(anatomy::anglesToBasalTurn(approach, (*scala)->entry()));
}

}  // namespace perilymph::gui
