// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ContactPositions.h"

#include <algorithm>
#include <cmath>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/analysis/Tonotopy.h"
#include "perilymph/mechanics/Outcome.h"

namespace perilymph::analysis {

namespace {

/// Every contact of a snapshot, from the tip; none with fewer than 2 nodes.
std::vector<mechanics::ContactOutcome> outcomesOf(const anatomy::ScalaTympani& scala,
                                                  const electrode::ArrayDesign& array,
                                                  const haptics::Snapshot& now)
{
  const std::size_t count = std::min<std::size_t>(now.nodes, mechanics::maxNodes);
  if (count < 2) return {};
  std::vector<Eigen::Vector3d> nodes_W;
  for (std::size_t i = 0; i < count; ++i)
    nodes_W.emplace_back(now.node_W[i][0], now.node_W[i][1], now.node_W[i][2]);
  return mechanics::outcomeOf(scala, array, {nodes_W, {}, Eigen::Vector3d::UnitX()});
}

}  // namespace

std::vector<ContactPosition> contactPositions(const anatomy::ScalaTympani& scala,
                                              const electrode::ArrayDesign& array,
                                              const haptics::Snapshot& now)
{
  const std::size_t count = std::min<std::size_t>(now.nodes, mechanics::maxNodes);
  const auto outcome = outcomesOf(scala, array, now);
  if (outcome.empty()) return {};
  const OrganOfCorti organ(scala);

  std::vector<ContactPosition> contacts;
  const double length = array.length.si();
  for (const mechanics::ContactOutcome& each : outcome) {
    const double node = std::round((1.0 - each.fromTip / length) * static_cast<double>(count - 1));
    ContactPosition contact;
    contact.number = static_cast<int>(contacts.size()) + 1;
    contact.isInserted = each.isInside;
    contact.depth = meters(now.output.depth - each.fromTip);
    if (each.isInside) {
      contact.angle = radians(each.angle);
      contact.coverage = organ.fractionAt(contact.angle);
      contact.frequency_Hz = greenwoodFrequency(1.0 - contact.coverage);
      contact.isAbove = now.isAbove[static_cast<std::size_t>(std::max(0.0, node))];
      contact.toModiolus = meters(contact.isAbove ? -1.0 : each.toInnerWall);
    }
    contacts.push_back(contact);
  }
  return contacts;
}

Angle angularInsertionDepth(const std::vector<ContactPosition>& contacts)
{
  const auto apical = std::ranges::find_if(contacts, &ContactPosition::isInserted);
  return apical == contacts.end() ? Angle{} : apical->angle;
}

Angle angularInsertionDepth(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array,
                            const haptics::Snapshot& now)
{
  const auto outcome = outcomesOf(scala, array, now);
  const auto apical = std::ranges::find_if(outcome, &mechanics::ContactOutcome::isInside);
  return apical == outcome.end() ? Angle{} : radians(apical->angle);
}

double cochlearCoverage(const std::vector<ContactPosition>& contacts)
{
  double coverage = 0.0;
  for (const ContactPosition& contact : contacts)
    if (contact.isInserted) coverage = std::max(coverage, contact.coverage);
  return coverage;
}

}  // namespace perilymph::analysis
