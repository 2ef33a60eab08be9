// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/ForceCourse.h"

#include <algorithm>

#include "perilymph/figures/Strings.h"

namespace perilymph::planning {

namespace {

/// Rows from one to before another.
struct Rows {
  std::size_t first, end;
};

figures::FigureBand bandOver(const std::vector<ForceBand>& force, Rows rows, double Band::*low,
                             double Band::*high)
{
  figures::FigureBand band;
  for (std::size_t i = rows.first; i < rows.end; ++i) {
    band.x.push_back(force[i].depth_mm);
    band.low.push_back(force[i].force_mN.*low);
    band.high.push_back(force[i].force_mN.*high);
  }
  return band;
}

}  // namespace

ForceCourse courseOf(const ArrayPlan& plan)
{
  ForceCourse course;
  const std::vector<ForceBand>& force = plan.force;
  if (force.empty()) return course;
  std::size_t all = 0;
  for (const ForceBand& each : force) all = std::max(all, each.draws);
  std::size_t quarters = 4;  // of the simulations that went on at the last count
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (force[i].draws == all) course.whole = i + 1;
    const std::size_t after = i + 1 < force.size() ? force[i + 1].draws : 0;
    if (after >= force[i].draws) continue;
    const ForceCourse::Mark mark{force[i].depth_mm, force[i].force_mN.median, force[i].draws};
    course.ends.push_back(mark);
    const bool isLast = after == 0;
    if (!isLast && 4 * after > (quarters - 1) * all) continue;
    while (quarters > 1 && 4 * after <= (quarters - 1) * all) --quarters;
    course.counts.push_back(mark);
  }
  return course;
}

void addForceCourse(figures::Figure& figure, const ArrayPlan& plan, const ForceLabels& labels,
                    const figures::Ink& ink, double dash)
{
  constexpr double fewDash = 2.0, wideOpacity = 0.18, narrowOpacity = 0.35, paler = 0.5;
  if (plan.force.empty()) return;
  const ForceCourse course = courseOf(plan);
  // both parts share the last row of all, so that they join
  const Rows parts[] = {{0, course.whole}, {course.whole - 1, plan.force.size()}};
  for (const bool isNarrow : {false, true}) {
    if (isNarrow && labels.narrow.empty()) continue;
    for (const Rows& rows : parts) {
      const bool isWhole = rows.first == 0 && rows.end == course.whole;
      auto band = isNarrow ? bandOver(plan.force, rows, &Band::lowerQuartile, &Band::upperQuartile)
                           : bandOver(plan.force, rows, &Band::low, &Band::high);
      band.ink = figures::ink::tint(
          ink, (isNarrow ? narrowOpacity : wideOpacity) * (isWhole ? 1.0 : paler));
      if (isWhole) band.label = isNarrow ? labels.narrow : labels.wide;
      figure.bands.push_back(std::move(band));
    }
  }
  for (const Rows& rows : parts) {
    const bool isWhole = rows.first == 0 && rows.end == course.whole;
    figures::FigureCurve median{
        isWhole ? labels.median : "", {}, {}, isWhole ? ink : figures::ink::tint(ink, 0.7), 1.5,
        isWhole ? dash : fewDash};
    for (std::size_t i = rows.first; i < rows.end; ++i) {
      median.x.push_back(plan.force[i].depth_mm);
      median.y.push_back(plan.force[i].force_mN.median);
    }
    figure.curves.push_back(std::move(median));
  }
  figures::FigureValues ends;
  ends.label = labels.ends;
  ends.ink = ink;
  ends.shape = figures::MarkerShape::ring;
  for (const ForceCourse::Mark& each : course.ends) {
    ends.x.push_back(each.depth_mm);
    ends.y.push_back(each.force_mN);
  }
  figure.values.push_back(std::move(ends));
  for (const ForceCourse::Mark& each : course.counts)
    figure.texts.push_back(
        {figures::filled(labels.count, {std::to_string(each.draws), std::to_string(plan.draws)}),
         each.depth_mm, each.force_mN, ink});
}

}  // namespace perilymph::planning
