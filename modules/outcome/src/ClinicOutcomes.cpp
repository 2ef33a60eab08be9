// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/ClinicOutcomes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/planning/PlanSummary.h"

namespace perilymph::outcome {

namespace {

int yearOf(const std::string& utc)
{
  int year = 0;
  for (std::size_t i = 0; i < 4 && i < utc.size() && utc[i] >= '0' && utc[i] <= '9'; ++i)
    year = 10 * year + (utc[i] - '0');
  return year;
}

/// To a tenth: "53.6", "28".
std::string shown(double value)
{
  std::string text = figures::fixed(value, 1);
  if (text.ends_with(".0")) text.erase(text.size() - 2);
  return text;
}

Result<void> checkValue(Phrase what, const Uncertain& measured, Range range, const Sentence& place)
{
  if (!std::isfinite(measured.value) || measured.value < range.low || measured.value > range.high)
    return Error{"%1 of %2 is %3; %4 to %5 is allowed. Check the contacts found in the CT.",
                 Sentence(what),
                 place,
                 shown(measured.value),
                 shown(range.low),
                 shown(range.high)};
  const double widest = range.high - range.low;
  if (!std::isfinite(measured.sd) || measured.sd < 0.0 || measured.sd > widest)
    return Error{
        "%1 of %2 has the standard deviation %3; 0 to %4 is allowed. Check the contacts found in "
        "the CT.",
        Sentence(what), place, shown(measured.sd), shown(widest)};
  return {};
}

std::size_t binOf(double percentile)
{
  return std::min(percentileBins - 1,
                  static_cast<std::size_t>(percentile * static_cast<double>(percentileBins)));
}

void addTo(ArrayOutcomes& arrays, const ScoredOutcome& ear)
{
  arrays.depth.add(ear.percentile);
  ++arrays.depthPercentiles[binOf(ear.percentile)];
  arrays.depthDifferences_mm.push_back(ear.depth_mm.value - ear.plannedDepth_mm.median);
  if (!ear.anglePercentile) return;
  arrays.angle.add(*ear.anglePercentile);
  ++arrays.anglePercentiles[binOf(*ear.anglePercentile)];
}

/// Learns the shift of angles: of the measured angle against the line through the simulations' angles over
/// their depths, at the measured length.
void learnAngle(AngleOffset& offset, const MeasuredOutcome& outcome)
{
  const auto &depths = outcome.plan.depths_mm, &angles = outcome.plan.angles_deg;
  if (!outcome.angle_deg || angles.size() != depths.size() || depths.size() < 3) return;
  const auto n = static_cast<double>(depths.size());
  double x = 0.0, y = 0.0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    x += depths[i] / n;
    y += angles[i] / n;
  }
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    xx += (depths[i] - x) * (depths[i] - x);
    xy += (depths[i] - x) * (angles[i] - y);
    yy += (angles[i] - y) * (angles[i] - y);
  }
  if (!(xx > 0.0)) return;
  const double slope = xy / xx;
  const double residual = std::max(0.0, yy - slope * xy) / (n - 2.0);
  const double ofLength = slope * outcome.depth_mm.sd;
  const double variance =
      residual + ofLength * ofLength + outcome.angle_deg->sd * outcome.angle_deg->sd;
  if (!(variance > 0.0)) return;
  offset.add(outcome.angle_deg->value - (y + slope * (outcome.depth_mm.value - x)),
             std::sqrt(variance));
}

}  // namespace

Result<void> checkOutcome(const MeasuredOutcome& outcome, const Sentence& name)
{
  if (const auto done = checkSurgery(outcome.surgery); !done)
    return Error{"%1: %2", name, done.error().message};
  if (const auto done = checkValue(Phrase{"The inserted length [mm]"}, outcome.depth_mm,
                                   analysis::physical::depth_mm, name);
      !done)
    return done.error();
  if (outcome.angle_deg)
    if (const auto done = checkValue(Phrase{"The angular insertion depth [degrees]"},
                                     *outcome.angle_deg, analysis::physical::angle_deg, name);
        !done)
      return done.error();
  // Beyond its own length within three errors no array lies in a cochlea. It counts from the opening, which is before
  // the round window: an array that is in up to its mark at the window is deeper by as much.
  constexpr double errors = 3.0;
  const double longest_mm = outcome.plan.insertable_mm + inMillimeters(anatomy::Cochlea{}.leadIn) +
                            errors * outcome.depth_mm.sd;
  if (outcome.plan.insertable_mm > 0.0 && outcome.depth_mm.value > longest_mm)
    return Error{
        "The inserted length of %1 is %2 mm, and %3 is %4 mm long. Check that the CT is of this "
        "ear, "
        "and the contacts found in it.",
        name, shown(outcome.depth_mm.value), outcome.array, shown(outcome.plan.insertable_mm)};
  if (outcome.plan.depths_mm.empty())
    return Error{"The plan of %1 has no simulation of %2. Plan that array.", name, outcome.array};
  return {};
}

void BandHits::add(double percentile)
{
  ++all;
  if (percentile >= 0.25 && percentile <= 0.75) ++inHalf;
  if (percentile >= 0.05 && percentile <= 0.95) ++inNinety;
}

double percentileAmong(const std::vector<double>& simulated, const Uncertain& measured)
{
  double below = 0.0;
  for (const double each : simulated) {
    const double off = measured.value - each;
    below += measured.sd > 0.0 ? planning::normalBelow(off / measured.sd)
             : off > 0.0       ? 1.0
             : off < 0.0       ? 0.0
                               : 0.5;
  }
  return (below + 0.5) / (static_cast<double>(simulated.size()) + 1.0);
}

Result<ClinicOutcomes> compareOutcomes(std::vector<MeasuredOutcome> outcomes,
                                       const LeftOut& leftOut)
{
  std::stable_sort(outcomes.begin(), outcomes.end(), [](const auto& one, const auto& other) {
    return one.surgeryUtc < other.surgeryUtc;
  });
  ClinicOutcomes clinic;
  clinic.leftOut = leftOut;
  std::map<std::string, ArrayOutcomes> arrays;
  ArrayOutcomes all;
  for (const MeasuredOutcome& each : outcomes) {
    const Sentence name{"ear %1", clinic.ears.size() + 1};
    if (const auto done = checkOutcome(each, name); !done) return done.error();
    ScoredOutcome ear;
    ear.year = yearOf(each.surgeryUtc);
    ear.array = each.array;
    ear.stopReason = each.surgery.stopReason;
    ear.evidence = evidenceOf(each.surgery, each.isDisplaced);
    ear.depth_mm = each.depth_mm;
    ear.plannedDepth_mm = planning::bandOf(each.plan.depths_mm);
    ear.percentile = percentileAmong(each.plan.depths_mm, each.depth_mm);
    if (each.angle_deg && !each.plan.angles_deg.empty()) {
      ear.angle_deg = each.angle_deg;
      ear.plannedAngle_deg = planning::bandOf(each.plan.angles_deg);
      ear.anglePercentile = percentileAmong(each.plan.angles_deg, *each.angle_deg);
    }
    // f counts from one friction
    const bool isOfOneFriction = !clinic.friction || *clinic.friction == each.plan.friction;
    if (each.plan.stops && !each.plan.stops->draws.empty() && isOfOneFriction) {
      clinic.friction = each.plan.friction;
      ear.resistance = clinic.resistance.add(
          {ear.evidence, each.depth_mm.value, each.depth_mm.sd, each.plan.insertable_mm, ear.year},
          *each.plan.stops);
      clinic.byClinic.add(ear.resistance->percentile);
    } else {
      ear.evidence = Evidence::none;
    }
    learnAngle(clinic.angleOffset, each);
    addTo(all, ear);
    ArrayOutcomes& own = arrays[each.array];
    own.array = each.array;
    addTo(own, ear);
    clinic.ears.push_back(std::move(ear));
  }
  clinic.arrays.push_back(std::move(all));
  for (auto& [name, own] : arrays) clinic.arrays.push_back(std::move(own));
  return clinic;
}

}  // namespace perilymph::outcome
