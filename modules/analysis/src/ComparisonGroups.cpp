// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ComparisonGroups.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ComparisonColumns.h"
#include "TableColumns.h"
#include "perilymph/analysis/Score.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/session/ScenarioChoices.h"

namespace perilymph::analysis {

namespace {

std::string frictionOf(const ComparedInsertion& each)
{
  return each.settings.coefficient + " (" + each.settings.friction + ")";
}

std::string speedOf(const ComparedInsertion& each)
{
  const auto& speed = each.settings.speed;
  return speed ? session::shortestDecimal(std::round(asMillimeters(*speed) * 1e9) / 1e9) + " mm/s"
               : "by hand";
}

std::string valueOf(const ComparedInsertion& each, GroupKey key)
{
  switch (key) {
    case GroupKey::array:
      return each.subject.array;
    case GroupKey::technique:
      return each.subject.technique;
    case GroupKey::friction:
      return frictionOf(each);
    case GroupKey::speed:
      return speedOf(each);
    case GroupKey::patient:
      break;
  }
  return each.subject.patient;
}

std::string joined(const std::vector<std::string>& values)
{
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : " · ") + value;
  return text;
}

std::optional<double> scoreTotal(const ComparedInsertion& each)
{
  const auto score = scoreOf(each);
  return score ? std::optional(score->total) : std::nullopt;
}

}  // namespace

std::string InsertionGroup::name() const { return joined(values); }

std::string InsertionGroup::title() const
{
  std::vector<std::string> shown = values;
  for (std::string& value : shown)
    if (value == session::nameOf(session::Technique::advanceOffStylet))
      value = "advance off-stylet";
  return joined(shown);
}

std::vector<Phrase> differingIn(const std::vector<ComparedInsertion>& insertions,
                                const InsertionGroup& group)
{
  using Insertion = ComparedInsertion;
  using session::shortestDecimal;
  using Text = std::string (*)(const Insertion&);
  const std::pair<Phrase, Text> all[] = {
      {Phrase{"friction"}, frictionOf},
      {Phrase{"set speed"}, speedOf},
      {Phrase{"approach"},
       [](const Insertion& each) {
         return each.settings.opening + shortestDecimal(each.settings.approachTilt) + " " +
                shortestDecimal(each.settings.approachTurn);
       }},
      {Phrase{"stop"},
       [](const Insertion& each) {
         return shortestDecimal(each.stopTravel) + " " + shortestDecimal(each.settings.stopForce);
       }},
      {Phrase{"cochlea"}, [](const Insertion& each) { return each.subject.cochlea; }},
      {Phrase{"array"}, [](const Insertion& each) { return each.subject.array; }},
      {Phrase{"technique"}, [](const Insertion& each) { return each.subject.technique; }},
      {Phrase{"ending"},
       [](const Insertion& each) { return std::string(haptics::nameOf(each.end)); }}};
  std::vector<Phrase> differing;
  for (const auto& [name, textOf] : all) {
    std::set<std::string> texts;
    for (const std::size_t member : group.members) texts.insert(textOf(insertions[member]));
    if (texts.size() > 1) differing.push_back(name);
  }
  return differing;
}

std::vector<InsertionGroup> groupsOf(const std::vector<ComparedInsertion>& insertions,
                                     const std::vector<GroupKey>& keys)
{
  if (keys.empty()) return {};
  std::map<std::vector<std::string>, std::vector<std::size_t>> found;
  for (std::size_t i = 0; i < insertions.size(); ++i) {
    std::vector<std::string> values;
    for (const GroupKey key : keys) values.push_back(valueOf(insertions[i], key));
    found[values].push_back(i);
  }
  std::vector<InsertionGroup> groups;
  for (const auto& [values, members] : found) groups.push_back({values, members});
  return groups;
}

const std::vector<ComparedQuantity>& comparedQuantities()
{
  using Insertion = ComparedInsertion;
  using Value = std::optional<double>;
  static const std::vector<ComparedQuantity> quantities = {
      {"peak_N", Phrase{"peak insertion force"}, "mN", 1e3, 0,
       [](const Insertion& each) -> Value { return each.profile.peak.force; }},
      {"array_peak_N", Phrase{"peak without ribs at the opening"}, "mN", 1e3, 0,
       [](const Insertion& each) -> Value { return each.arrayPeak.force; }},
      {"end_N", Phrase{"end force"}, "mN", 1e3, 0,
       [](const Insertion& each) -> Value { return each.profile.endForce; }},
      {"work_mJ", Phrase{"insertion work"}, "mJ", 1.0, 2,
       [](const Insertion& each) -> Value { return each.profile.work * 1e3; }},
      {"final_depth_mm", Phrase{"insertion depth at the end"}, "mm", 1.0, 1,
       [](const Insertion& each) -> Value { return asMillimeters(each.profile.finalDepth); }},
      {"deepest_angle_deg", Phrase{"tip angle"}, "°", 1.0, 0,
       [](const Insertion& each) -> Value { return asDegrees(each.profile.deepestAngle); }},
      {"mean_speed_mm_s", Phrase{"mean speed"}, "mm/s", 1.0, 2,
       [](const Insertion& each) -> Value { return asMillimeters(each.motion.meanSpeed()); }},
      {"duration_s", Phrase{"insertion time"}, "s", 1.0, 1,
       [](const Insertion& each) -> Value { return each.profile.duration; }},
      {"reversals", Phrase{"reversals"}, "", 1.0, 1,
       [](const Insertion& each) -> Value { return each.reversals; }},
      {"score", Phrase{"score"}, "", 1.0, 0, scoreTotal}};
  return quantities;
}

std::vector<double> valuesOf(const std::vector<ComparedInsertion>& insertions,
                             const InsertionGroup& group, const ComparedQuantity& quantity)
{
  std::vector<double> values;
  for (const std::size_t member : group.members)
    if (const auto value = quantity.of(insertions[member])) values.push_back(*value);
  return values;
}

std::string groupsCsv(const std::vector<ComparedInsertion>& insertions,
                      const std::vector<InsertionGroup>& groups)
{
  std::string csv = headerOf(groupColumns()) + "\n";
  for (const InsertionGroup& group : groups)
    for (const ComparedQuantity& quantity : comparedQuantities()) {
      const std::vector<double> values = valuesOf(insertions, group, quantity);
      csv += csvField(group.name()) + "," + quantity.key + "," + std::to_string(values.size());
      csv += values.empty() ? std::string(",") : nextField(statisticsOf(values).mean);
      if (const auto interval = meanWithInterval(values))
        csv += nextField(statisticsOf(values).standardDeviation) + nextField(interval->low) +
               nextField(interval->high);
      else
        csv += ",,,";
      csv += "\n";
    }
  return csv;
}

std::string differencesCsv(const std::vector<ComparedInsertion>& insertions,
                           const std::vector<InsertionGroup>& groups)
{
  std::string csv = headerOf(differenceColumns()) + "\n";
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (std::size_t j = i + 1; j < groups.size(); ++j)
      for (const ComparedQuantity& quantity : comparedQuantities()) {
        const auto one = valuesOf(insertions, groups[i], quantity);
        const auto other = valuesOf(insertions, groups[j], quantity);
        if (one.empty() || other.empty()) continue;
        csv += csvField(groups[i].name()) + "," + csvField(groups[j].name()) + "," + quantity.key +
               "," + std::to_string(one.size()) + "," + std::to_string(other.size()) +
               nextField(statisticsOf(one).mean - statisticsOf(other).mean);
        if (const auto welch = welchDifference(one, other))
          csv += nextField(welch->difference.low) + nextField(welch->difference.high) +
                 nextField(welch->degreesOfFreedom);
        else
          csv += ",,,";
        csv += "\n";
      }
  return csv;
}

MeanCurve meanCurve(const std::vector<ComparedInsertion>& insertions, const InsertionGroup& group,
                    CurveAxis axis)
{
  const double spacing = stepOf(axis);
  std::map<long, std::vector<double>> forces;
  for (const std::size_t member : group.members)
    for (const AxisPoint& point : curveOver(insertions[member], axis))
      forces[std::lround(point.place / spacing)].push_back(point.force);
  MeanCurve curve;
  for (const auto& [step, values] : forces) {
    if (2 * values.size() < group.members.size()) continue;
    const SampleStatistics here = statisticsOf(values);
    curve.place.push_back(static_cast<double>(step) * spacing);
    curve.mean.push_back(here.mean);
    curve.sd.push_back(here.standardDeviation);
    curve.count.push_back(values.size());
  }
  return curve;
}

}  // namespace perilymph::analysis
