// SPDX-License-Identifier: BSD-3-Clause
// Bands, probabilities and influences from the insertions of a plan.

#include "perilymph/planning/PlanSummary.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "FrequencyAllocation.h"
#include "PlanComparison.h"
#include "PlannedValues.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/analysis/Tonotopy.h"
#include "perilymph/foundation/Quantile.h"

namespace perilymph::planning {

namespace {

using haptics::InsertionEnd;

/// Lower edge of a band, and tolerances of hasConverged().
constexpr double edge = 0.05, edgeTolerance = 0.1, angleTolerance_deg = 5.0, peakTolerance = 0.05;

using Insertions = std::vector<const PlannedInsertion*>;

Insertions insertionsOf(const std::vector<PlannedInsertion>& all, std::size_t array)
{
  Insertions own;
  for (const PlannedInsertion& each : all)
    if (each.array == array) own.push_back(&each);
  return own;
}

Insertions runOf(Insertions all)
{
  std::erase_if(all, [](const PlannedInsertion* each) { return !isRun(*each); });
  return all;
}

template <class Value>
std::vector<double> valuesOf(const Insertions& all, const Value& value)
{
  std::vector<double> values;
  for (const PlannedInsertion* each : all) values.push_back(value(*each));
  return values;
}

template <class Event>
analysis::Estimate probability(const Insertions& all, const Event& event)
{
  const auto hits = std::count_if(all.begin(), all.end(),
                                  [&](const PlannedInsertion* each) { return event(*each); });
  return analysis::proportionOf(static_cast<std::size_t>(hits), all.size());
}

analysis::Estimate probabilityOf(const Insertions& all, const std::vector<InsertionEnd>& ends)
{
  return probability(all, [&](const PlannedInsertion& each) {
    return std::find(ends.begin(), ends.end(), each.insertion.end) != ends.end();
  });
}

/// Depth at which a profile first reaches a force [mm], linear between its points.
std::optional<double> depthAt(const std::vector<analysis::DepthForce>& profile, Force force)
{
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (profile[i].force < force) continue;
    if (i == 0) return inMillimeters(profile[i].depth);
    const auto& [depth, before] = profile[i - 1];
    const double alpha = (force - before) / (profile[i].force - before);
    return inMillimeters(depth + alpha * (profile[i].depth - depth));
  }
  return std::nullopt;
}

/// Bands as deep as any simulation went: what few reached is shown as of few, not left out.
std::vector<ForceBand> forceBands(const Insertions& all)
{
  std::vector<ForceBand> bands;
  for (int i = 0;; ++i) {
    const double depth_mm = i * inMillimeters(bandSpacing);
    std::vector<double> forces;
    bool isBelow = false;  // some profile goes on deeper
    for (const PlannedInsertion* each : all)
      for (const analysis::DepthForce& point : each->insertion.profile) {
        const double off = inMillimeters(point.depth) - depth_mm;
        if (std::fabs(off) < 1e-6) forces.push_back(inMillinewtons(point.force));
        isBelow = isBelow || off > 1e-6;
      }
    if (!forces.empty()) bands.push_back({depth_mm, forces.size(), bandOf(forces)});
    if (!isBelow) return bands;
  }
}

std::vector<ContactBand> contactBands(const Insertions& all, const std::vector<double>& filter_Hz)
{
  std::size_t count = 0;
  for (const PlannedInsertion* each : all) count = std::max(count, each->insertion.contacts.size());
  std::vector<ContactBand> bands;
  for (std::size_t i = 0; i < count; ++i) {
    const double filter = i < filter_Hz.size() ? filter_Hz[i] : 0.0;
    std::vector<double> angles, distances, places, mismatches;
    for (const PlannedInsertion* each : all) {
      if (i >= each->insertion.contacts.size()) continue;
      const analysis::ContactPosition& contact = each->insertion.contacts[i];
      if (!contact.isInserted) continue;
      angles.push_back(inDegrees(contact.angle));
      // negative where no lumen lies toward the modiolus
      if (contact.toModiolus.si() >= 0.0) distances.push_back(inMillimeters(contact.toModiolus));
      places.push_back(contact.coverage);
      if (filter > 0.0)
        mismatches.push_back(
            analysis::semitones(filter, analysis::spiralGanglionFrequency(contact.angle)));
    }
    ContactBand band;
    band.number = static_cast<int>(i) + 1;
    band.draws = angles.size();
    band.filter_Hz = filter;
    if (!mismatches.empty()) band.mismatch_semitones = bandOf(mismatches);
    if (!angles.empty()) {
      band.angle_deg = bandOf(angles);
      if (!distances.empty()) band.toModiolus_mm = bandOf(distances);
      band.greenwood_Hz = analysis::greenwoodFrequency(1.0 - quantile(places, 0.5));
      band.greenwoodLow_Hz = analysis::greenwoodFrequency(1.0 - quantile(places, 0.95));
      band.greenwoodHigh_Hz = analysis::greenwoodFrequency(1.0 - quantile(places, 0.05));
      band.spiralGanglion_Hz = analysis::spiralGanglionFrequency(degrees(band.angle_deg.median));
    }
    bands.push_back(band);
  }
  return bands;
}

/// Squared rank correlation, adjusted for chance; 0 if one does not vary.
double explained(const std::vector<double>& x, const std::vector<double>& y)
{
  const std::vector<double> a = analysis::ranksOf(x), b = analysis::ranksOf(y);
  const double middle = 0.5 * (static_cast<double>(x.size()) - 1.0);
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    xx += (a[i] - middle) * (a[i] - middle);
    xy += (a[i] - middle) * (b[i] - middle);
    yy += (b[i] - middle) * (b[i] - middle);
  }
  if (x.size() < 3 || !(xx > 0.0 && yy > 0.0)) return 0.0;
  const auto count = static_cast<double>(x.size());
  return std::max(0.0, 1.0 - (1.0 - xy * xy / (xx * yy)) * (count - 1.0) / (count - 2.0));
}

/// The part of a band's width that remains if the part `known` of the variance were known.
double widthKnowing(const Band& band, double known)
{
  return (band.high - band.low) * std::sqrt(std::max(0.0, 1.0 - known));
}

/// Error of a measure in the patient's file; nothing for other inputs.
std::optional<Length> errorOf(const std::string& input, const anatomy::BasalTurnErrors& errors)
{
  if (input == "A") return errors.a;
  if (input == "B") return errors.b;
  if (input == "H") return errors.h.value_or(analysis::measuringError);
  return std::nullopt;
}

/// Independent inputs explain no more than all of the variance, though estimates may add to more by chance:
/// these are reduced in proportion.
void limitToOne(std::vector<Influence>& influences, double Influence::*part)
{
  double sum = 0.0;
  for (const Influence& each : influences) sum += each.*part;
  if (sum > 1.0)
    for (Influence& each : influences) each.*part /= sum;
}

/// None of fewer than `fewestForBand` insertions, where chance would decide them.
std::vector<Influence> influencesOn(const Insertions& all, const ArrayPlan& plan,
                                    const anatomy::BasalTurnErrors& errors)
{
  struct Input {
    Phrase name;
    double (*value)(const PlannedInsertion&);
  };
  static constexpr Input inputs[] = {
      {Phrase{"A"}, [](const PlannedInsertion& each) { return each.a_mm; }},
      {Phrase{"B"}, [](const PlannedInsertion& each) { return each.b_mm; }},
      {Phrase{"H"}, [](const PlannedInsertion& each) { return each.h_mm; }},
      {Phrase{"share of A"}, [](const PlannedInsertion& each) { return each.a1_deviate; }},
      {Phrase{"share of B"}, [](const PlannedInsertion& each) { return each.b1_deviate; }},
      {Phrase{"section at the base"}, [](const PlannedInsertion& each) { return each.section; }},
      {Phrase{"section in the second turn"},
       [](const PlannedInsertion& each) { return each.sectionSecond; }},
      {Phrase{"dip of the basal turn"}, [](const PlannedInsertion& each) { return each.dip_mm; }},
      {Phrase{"wave of the outer wall"}, [](const PlannedInsertion& each) { return each.radius; }},
      {Phrase{"height without H"}, [](const PlannedInsertion& each) { return each.height; }},
      {Phrase{"lining"}, [](const PlannedInsertion& each) { return each.lining_mm; }},
      {Phrase{"membrane"}, [](const PlannedInsertion& each) { return each.membrane_N_m; }},
      {Phrase{"approach tilt"}, [](const PlannedInsertion& each) { return each.tilt_deg; }},
      {Phrase{"approach turn"}, [](const PlannedInsertion& each) { return each.turn_deg; }},
      {Phrase{"stiffness"}, [](const PlannedInsertion& each) { return each.stiffness; }},
      {Phrase{"packing of the wires"}, [](const PlannedInsertion& each) { return each.packing; }},
      {Phrase{"taper of the array"},
       [](const PlannedInsertion& each) { return each.lastContact_mm; }},
      {Phrase{"friction"}, [](const PlannedInsertion& each) { return each.friction; }},
      {Phrase{"speed"}, [](const PlannedInsertion& each) { return each.speed_mm_s; }},
      {Phrase{"grip"}, [](const PlannedInsertion& each) { return each.free_mm; }},
      {Phrase{"force limit"}, [](const PlannedInsertion& each) { return each.stop_mN; }},
      {Phrase{"intended depth"}, [](const PlannedInsertion& each) { return each.intended_mm; }}};
  std::vector<Influence> influences;
  if (all.size() < fewestForBand) return influences;
  for (const Input& input : inputs) {
    const std::vector<double> values = valuesOf(all, input.value);
    Influence one;
    one.input = Sentence(input.name);
    one.onAngle = explained(values, valuesOf(all, angleOf));
    one.onPeak = explained(values, valuesOf(all, peakOf));
    influences.push_back(one);
  }
  limitToOne(influences, &Influence::onAngle);
  limitToOne(influences, &Influence::onPeak);
  for (Influence& one : influences) {
    one.angleWidth_deg = widthKnowing(plan.angle_deg, one.onAngle);
    one.peakWidth_mN = widthKnowing(plan.peak_mN, one.onPeak);
    if (const auto error = errorOf(one.input, errors); error && *error > finerError) {
      const double rest = finerError / *error;
      one.finerAngleWidth_deg = widthKnowing(plan.angle_deg, one.onAngle * (1.0 - rest * rest));
    }
  }
  std::stable_sort(influences.begin(), influences.end(),
                   [](const Influence& a, const Influence& b) { return a.onAngle > b.onAngle; });
  return influences;
}

void addForceEvents(ArrayPlan& plan, const Insertions& all, const Thresholds& thresholds)
{
  const auto reaches = [&](Force strength) {
    return probability(
        all, [=](const PlannedInsertion& each) { return each.insertion.partition >= strength; });
  };
  plan.ruptured =
      probability(all, [](const PlannedInsertion& each) { return each.insertion.isRuptured; });
  plan.translocated =
      probability(all, [](const PlannedInsertion& each) { return each.insertion.isTranslocated; });
  plan.reachesWeakest = reaches(thresholds.ruptureLow);
  plan.reachesStrongest = reaches(thresholds.ruptureHigh);
  std::vector<double> depths;
  for (const PlannedInsertion* each : all)
    if (const auto depth = depthAt(each->insertion.profile, thresholds.felt))
      depths.push_back(*depth);
  plan.felt = analysis::proportionOf(depths.size(), all.size());
  if (!depths.empty()) plan.firstResistance_mm = bandOf(depths);
}

Band restedBand(const Insertions& all, std::optional<Force> analysis::ClinicalInsertion::*force)
{
  std::vector<double> values;
  for (const PlannedInsertion* each : all)
    if (const auto& found = each->insertion.*force) values.push_back(inMillinewtons(*found));
  return bandOf(std::move(values));
}

ArrayPlan summaryOf(const Insertions& all, const PlannedArray& array, const Thresholds& thresholds,
                    const anatomy::BasalTurnErrors& errors)
{
  ArrayPlan plan;
  plan.draws = all.size();
  const Insertions run = runOf(all);
  const auto band = [&run](const auto& value) { return bandOf(valuesOf(run, value)); };
  plan.angle_deg = band(angleOf);
  plan.peak_mN = band(peakOf);
  plan.coverage_percent = band([](const PlannedInsertion& each) {
    return 100.0 * analysis::cochlearCoverage(each.insertion.contacts);
  });
  plan.depth_mm = band(depthOf);
  plan.end_mN = band(endOf);
  plan.after1s_mN = restedBand(run, &analysis::ClinicalInsertion::forceAfter1s);
  plan.after10s_mN = restedBand(run, &analysis::ClinicalInsertion::forceAfter10s);
  plan.partition_mN =
      band([](const PlannedInsertion& each) { return inMillinewtons(each.insertion.partition); });
  plan.full = probabilityOf(all, {InsertionEnd::finished});
  plan.allInside = probability(all, [](const PlannedInsertion& each) {
    const auto& contacts = each.insertion.contacts;
    return !contacts.empty() && std::all_of(contacts.begin(), contacts.end(),
                                            [](const auto& one) { return one.isInserted; });
  });
  plan.resisted = probabilityOf(all, {InsertionEnd::stoppedByResistance});
  plan.buckled = probabilityOf(all, {InsertionEnd::buckled});
  plan.foldedTip = probabilityOf(all, {InsertionEnd::foldedTip});
  plan.other = probabilityOf(all, {InsertionEnd::outOfOpening, InsertionEnd::jammed,
                                   InsertionEnd::fault, InsertionEnd::refused, InsertionEnd::none});
  addForceEvents(plan, all, thresholds);
  plan.force = forceBands(run);
  plan.contacts = contactBands(run, array.filter_Hz);
  plan.influences = influencesOn(run, plan, errors);
  return plan;
}

}  // namespace

Band bandOf(std::vector<double> values)
{
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double fraction) {
    return quantileOfSorted(values, fraction, QuantileRule::predictive);
  };
  return {at(0.05), at(0.25), at(0.5), at(0.75), at(0.95)};
}

std::vector<ArrayPlan> summarize(const PlanRequest& request,
                                 const std::vector<PlannedArray>& arrays,
                                 const Thresholds& thresholds,
                                 const std::vector<PlannedInsertion>& insertions)
{
  std::vector<ArrayPlan> plans;
  for (std::size_t i = 0; i < request.arrays.size(); ++i) {
    ArrayPlan plan = summaryOf(insertionsOf(insertions, i), arrays[i], thresholds,
                               analysis::errorsOf(request.patient));
    plan.array = request.arrays[i];
    plan.name = arrays[i].name;
    plans.push_back(std::move(plan));
  }
  return plans;
}

void addSummary(Plan& plan, const std::vector<PlannedArray>& arrays)
{
  plan.arrays = summarize(plan.request, arrays, plan.thresholds, plan.insertions);
  plan.differences = differencesOf(plan.arrays.size(), plan.insertions);
  if (plan.frictionSpread > 0.0)
    for (std::size_t i = 0; i < plan.arrays.size(); ++i) {
      const Insertions run = runOf(insertionsOf(plan.insertions, i));
      if (run.size() >= fewestForBand) plan.arrays[i].atMedianFriction = atMedianFriction(run);
    }
}

bool hasConverged(const Plan& plan)
{
  const auto stands = [&plan](std::size_t array, double (*value)(const PlannedInsertion&),
                              double tolerance) {
    std::vector<double> values = valuesOf(runOf(insertionsOf(plan.insertions, array)), value);
    if (values.size() < fewestForBand) return false;
    std::sort(values.begin(), values.end());
    const auto at = [&](double fraction) {
      return quantileOfSorted(values, fraction, QuantileRule::predictive);
    };
    // the quantiles one standard error of the fraction below and above
    const double error = std::sqrt(edge * (1.0 - edge) / static_cast<double>(values.size()));
    const double allowed = std::max(tolerance, edgeTolerance * (at(1.0 - edge) - at(edge)));
    return std::ranges::all_of(std::array{edge, 1.0 - edge}, [&](double fraction) {
      return 0.5 * (at(fraction + error) - at(fraction - error)) <= allowed;
    });
  };
  for (std::size_t i = 0; i < plan.arrays.size(); ++i)
    if (!stands(i, angleOf, angleTolerance_deg) ||
        !stands(i, peakOf, peakTolerance * plan.arrays[i].peak_mN.median))
      return false;
  return true;
}

}  // namespace perilymph::planning
