// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ContactDistances.h"

#include <algorithm>
#include <cmath>

#include "PlotSheet.h"
#include "perilymph/figures/Lines.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/mechanics/Outcome.h"

namespace perilymph::charts {

using figures::Anchor;
using figures::Disk;
using figures::Stroke;

namespace {

constexpr AxisRange usualDistance_mm{0.0, 1.5, 0.5};
constexpr double leftMargin_px = 30.0;
constexpr double line_px = 14.0;

}  // namespace

std::vector<ContactDistance> contactDistances(const ArrayInScala& now)
{
  std::vector<ContactDistance> contacts(now.array().contactsFromTip.size());
  if (now.nodes().empty()) return contacts;
  const auto outcome =
      mechanics::outcomeOf(now.scala(), now.array(), {now.nodes_W(), {}, Eigen::Vector3d::UnitX()});
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const mechanics::ContactOutcome& contact = outcome[i];
    if (!contact.isInside) continue;
    const bool isAbove = now.at(1e3 * contact.fromTip).isAbove;
    contacts[i] = {true, inDegrees(radians(contact.angle)),
                   isAbove ? -1.0 : 1e3 * contact.toInnerWall, isAbove};
  }
  return contacts;
}

figures::Drawing drawContactDistances(const std::vector<ContactDistance>& contacts, double width,
                                      double height, const ChartStyle& style)
{
  const figures::Palette& ink = figures::paletteOf(style.scheme);
  const ChartStrings& strings = style.strings;
  double max_mm = 0.0, sum_mm = 0.0;
  int inside = 0, translocated = 0;
  for (const ContactDistance& contact : contacts) {
    if (contact.isAbove) ++translocated;
    if (!contact.isInside || contact.toInnerWall_mm < 0.0) continue;
    max_mm = std::max(max_mm, contact.toInnerWall_mm);
    sum_mm += contact.toInnerWall_mm;
    ++inside;
  }
  const double count = std::max(1.0, static_cast<double>(contacts.size()));
  const AxisRange numbers{0.0, count + 1.0, count > 12.0 ? 5.0 : 2.0};
  const std::string mean = inside > 0 ? written(sum_mm / inside, 2, strings.decimalSign) : "";
  const std::string said =
      translocated == 0 && inside == 0 ? strings.noContactInside
      : translocated == 0 ? figures::filled(strings.meanAndInside, {mean, std::to_string(inside)})
      : inside == 0       ? figures::filled(strings.onlyAbove, {std::to_string(translocated)})
                          : figures::filled(strings.meanAndAbove,
                                            {mean, std::to_string(inside), std::to_string(translocated)});
  const bool fits = widthOfLabel(said) <= width - leftMargin_px;
  const std::vector<std::string> text = figures::linesOf(said, figures::labelSize, width);
  const double above = line_px * static_cast<double>(text.size()) + 8.0;
  PlotSheet sheet(width, height, {leftMargin_px, 4.0, above, 22.0}, numbers,
                  grown(usualDistance_mm, 0.0, max_mm), style);
  sheet.addYTicks(1);
  sheet.addXTicks(1, "");

  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactDistance& contact = contacts[i];
    const double number = static_cast<double>(i + 1);
    if (contact.isAbove) {
      const figures::PagePoint foot = sheet.at(number, 0.0);
      for (const double slope : {-1.0, 1.0})
        sheet.add(Stroke{{{foot.x - 4.0, foot.y - 6.0 - 4.0 * slope},
                          {foot.x + 4.0, foot.y - 6.0 + 4.0 * slope}},
                         ink.rupture,
                         1.5,
                         0.0});
    }
    if (!contact.isInside || contact.toInnerWall_mm < 0.0) continue;
    const figures::PagePoint head = sheet.at(number, contact.toInnerWall_mm);
    sheet.add(Stroke{{sheet.at(number, 0.0), head}, figures::faded(ink.silicone, 0.5), 1.5, 0.0});
    sheet.add(Disk{head, 2.5, ink.silicone, ink.silicone});
  }
  if (inside > 0) {
    const double y = sheet.y(sum_mm / inside);
    sheet.add(Stroke{{{sheet.left(), y}, {sheet.right(), y}}, ink.accent, 1.0, 4.0});
  }
  for (std::size_t i = 0; i < text.size(); ++i)
    sheet.write({fits ? sheet.left() : 0.0, line_px * static_cast<double>(i + 1)}, text[i],
                translocated > 0 ? ink.rupture
                : inside > 0     ? ink.accent
                                 : ink.quiet);
  return sheet.take();
}

}  // namespace perilymph::charts
