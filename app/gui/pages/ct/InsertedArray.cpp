// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/InsertedArray.h"

#include <algorithm>
#include <cmath>

namespace perilymph::gui {

namespace {

constexpr double approach_mm = 20.0;  // length of the insertion line outside the opening

}  // namespace

CtStudy::InsertedArray insertedArray(const ct::CochleaMeasures& measures,
                                     const electrode::ArrayDesign& design,
                                     const anatomy::ScalaTympani& scala,
                                     const anatomy::Approach& approach,
                                     const haptics::Snapshot& now)
{
  CtStudy::InsertedArray array;
  if (now.nodes < 2) return array;
  const double nodeDistance = design.length.si() / double(now.nodes - 1);
  std::vector<Eigen::Vector3d> nodes_W;
  for (std::size_t k = 0; k < now.nodes; ++k) {
    nodes_W.emplace_back(now.node_W[k][0], now.node_W[k][1], now.node_W[k][2]);
    if (!nodes_W.back().allFinite()) return {};
    const Length fromTip = Length::fromSi(nodeDistance * double(now.nodes - 1 - k));
    array.nodes.push_back({measures.fromAnatomy(nodes_W.back()),
                           0.5 * inMillimeters(design.sectionAt(fromTip).within)});
  }
  for (const Length fromTip : design.contactsFromTip) {
    const double place = std::clamp(double(now.nodes - 1) - fromTip.si() / nodeDistance, 0.0,
                                    double(now.nodes - 1) - 1e-9);
    const auto before = static_cast<std::size_t>(place);
    const double fraction = place - double(before);
    array.contacts_P.push_back(
        measures.fromAnatomy((1.0 - fraction) * nodes_W[before] + fraction * nodes_W[before + 1]));
  }
  const ct::ApproachLine line = ct::approachLine(measures, scala.entry(), approach);
  array.approach_P = {line.at(approach_mm), line.opening_P};
  return array;
}

imaging::PlanMarkups planOf(const CtStudy& study)
{
  imaging::PlanMarkups plan{.seriesKey = study.series().key, .marks = study.marks()};
  if (const auto& measures = study.measures(); measures && !study.isStale())
    plan.axis = {measures->center_P, measures->center_P + measures->h.value * measures->axis_P};
  const CtStudy::InsertedArray& array = study.array();
  if (array.nodes.empty()) return plan;
  plan.insertionLine = array.approach_P;
  for (const auto& node : array.nodes) plan.array.push_back(node.center_P);
  plan.contacts = array.contacts_P;
  return plan;
}

}  // namespace perilymph::gui
