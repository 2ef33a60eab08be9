// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stop_token>

#include "ComparisonColumns.h"
#include "ProfilePoints.h"
#include "TableColumns.h"
#include "perilymph/analysis/ColumnDictionary.h"
#include "perilymph/analysis/PublishedConditions.h"
#include "perilymph/analysis/Reference.h"
#include "perilymph/analysis/RoundedTravel.h"
#include "perilymph/analysis/Score.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/session/Csv.h"

namespace perilymph::analysis {

namespace {

/// The forces over depth and over the angle.
class AxisCurves {
public:
  void add(const haptics::TickOutput& now, ComparedInsertion& compared)
  {
    if (now.workflow == haptics::Workflow::idle) return;
    depth_.add(now.depth, now.axialForce, [&](double place, double force) {
      compared.overDepth.push_back({place, force});
    });
    angle_.add(now.angularDepth, now.axialForce, [&](double place, double force) {
      compared.overAngle.push_back({place, force});
    });
  }

private:
  FirstPassages depth_{stepOf(CurveAxis::depth)}, angle_{stepOf(CurveAxis::angle)};
};

/// A place on an axis in the unit of files: mm or degrees.
double inFile(CurveAxis axis, double place)
{
  return axis == CurveAxis::angle ? std::round(inDegrees(radians(place)) * 1e6) / 1e6
                                  : roundedMillimeters(place);
}

std::string coefficientOf(const mechanics::FrictionLaw& law)
{
  if (law.bySpeed.isEmpty()) return session::shortestDecimal(law.staticCoefficient);
  return session::shortestDecimal(law.bySpeed.minimum()) + " to " +
         session::shortestDecimal(law.bySpeed.maximum());
}

InsertionSettings settingsOf(const session::Scenario& scenario,
                             const session::RecordingFacts& facts)
{
  const auto textOf = [&](const std::string& key) {
    for (const auto& [name, value] : scenario.values())
      if (name == key && value.size() > 2) return value.substr(1, value.size() - 2);
    return std::string();
  };
  const session::InsertionParameters& parameters = scenario.parameters();
  InsertionSettings settings;
  settings.friction = textOf("friction");
  if (settings.friction.empty()) settings.friction = "own";
  settings.coefficient = coefficientOf(scenario.friction());
  if (facts.isScripted()) settings.speed = scenario.speed().si();
  settings.opening = textOf("opening");
  settings.approachTilt = parameters.approachTilt.si();
  settings.approachTurn = parameters.approachTurn.si();
  settings.stopForce = parameters.engine.stopForce;
  settings.seed = facts.seed;
  return settings;
}

/// A value that was set, without the rounding errors of its conversion to SI and back.
std::string settingField(double value) { return nextField(std::round(value * 1e9) / 1e9); }

}  // namespace

double shownPlace(CurveAxis axis, double place)
{
  return axis == CurveAxis::angle ? asDegrees(place) : asMillimeters(place);
}

double stepOf(CurveAxis axis)
{
  return axis == CurveAxis::angle ? degrees(1.0).si() : profileStep().si();
}

Result<ComparedInsertion> readCompared(const std::filesystem::path& file,
                                       const std::stop_token& stop)
{
  const auto recorded = session::RecordedInsertion::open(file, stop);
  if (!recorded) return recorded.error();
  const auto check = recorded->check();
  if (!check) return check.error();
  ComparedInsertion compared;
  compared.check = *check;
  compared.name = session::displayNameOf(file);
  compared.recording = file.filename().string();
  compared.scenario = recorded->facts().scenarioName;
  compared.subject = session::subjectOf(recorded->facts().scenarioText, file.string());
  electrode::ArrayDesign array;  // without ribs if the scenario can no longer be read
  Length passage;
  if (const auto scenario = session::parseScenario(recorded->facts().scenarioText, file.string())) {
    compared.hasPublishedConditions = hasPublishedConditions(*scenario);
    array = scenario->array();
    compared.stopTravel = scenario->stopTravel().si();
    compared.settings = settingsOf(*scenario, recorded->facts());
    if (const auto& opening = scenario->parameters().opening) passage = opening->passage;
  }
  const auto felt = forceFeltBySurgeons();
  RibPeaks ribs(array, passage);
  EventFinder events(array, felt ? felt->si() : 0.0);
  haptics::PeakForce peak;
  AxisCurves curves;
  compared.startedUtc = recorded->facts().startedUtc;
  ForceProfiler profiler;
  ReversalCounter reversals;
  MotionCounter motion;
  const auto read = recorded->forEach([&](const haptics::TickRecord& record) {
    profiler.add(record);
    reversals.add(record.output.travel);
    motion.add(record.output);
    ribs.add(record.output);
    peak.follow(record.output);
    events.add(record.tick, record.output, peak);
    curves.add(record.output, compared);
    compared.end = haptics::endOf(record.output);
    if ((record.output.status & haptics::partitionRuptured) != 0 &&
        (!compared.translocation ||
         compared.translocation->lengthAbove < record.output.translocation.lengthAbove))
      compared.translocation = record.output.translocation;
    return !stop.stop_requested();
  });
  if (!read) return read.error();
  if (stop.stop_requested()) return Error{"Stopped while reading %1.", file};
  compared.profile = profiler.profile();
  compared.reversals = reversals.reversals();
  compared.motion = motion.motion();
  compared.arrayPeak = ribs.array();
  compared.ribPeak = ribs.rib();
  compared.ribNumber = ribs.ribNumber();
  compared.events = events.events();
  if (compared.profile.ticks == 0)
    return Error{"%1 contains no samples. Record the insertion to another file.", file};
  return compared;
}

std::string labelOf(const ComparedInsertion& insertion)
{
  return insertion.check.damage.empty() ? insertion.name : insertion.name + " (changed by hand)";
}

std::vector<AxisPoint> curveOver(const ComparedInsertion& insertion, CurveAxis axis)
{
  if (axis == CurveAxis::depth) return insertion.overDepth;
  if (axis == CurveAxis::angle) return insertion.overAngle;
  std::vector<AxisPoint> curve;
  for (const CurvePoint& point : insertion.profile.curve)
    curve.push_back({point.travel, point.force});
  return curve;
}

std::string comparisonCsv(const std::vector<ComparedInsertion>& insertions)
{
  std::string csv = headerOf(comparisonColumns()) + "\n";
  for (const ComparedInsertion& each : insertions) {
    const ForceProfile& profile = each.profile;
    csv += csvField(labelOf(each)) + "," + csvField(each.scenario);
    for (const double value :
         {profile.peak.force, asMillimeters(profile.peak.travel), asMillimeters(profile.peakDepth),
          profile.work * 1e3, static_cast<double>(each.reversals), profile.duration,
          asMillimeters(profile.finalDepth), asDegrees(profile.finalAngle)})
      csv += nextField(value);
    if (const auto& found = each.translocation)
      csv += nextField(asDegrees(found->angle)) + nextField(found->force) +
             nextField(asMillimeters(found->lengthAbove));
    else
      csv += ",,,";
    for (const std::string* text :
         {&each.subject.array, &each.subject.technique, &each.subject.patient, &each.subject.side})
      csv += "," + csvField(*text);
    csv += nextField(each.arrayPeak.force) + nextField(asMillimeters(each.arrayPeak.depth));
    csv += each.ribPeak
               ? nextField(each.ribPeak->force) + nextField(asMillimeters(each.ribPeak->depth))
               : ",,";
    csv += nextField(profile.endForce) + nextField(asDegrees(profile.deepestAngle));
    const auto score = scoreOf(each);
    csv += (score ? nextField(score->total) : ",") + "," + std::to_string(scoreDefinition) +
           nextField(asMillimeters(each.motion.meanSpeed()));
    const InsertionSettings& set = each.settings;
    for (const std::string* text : {&each.recording, &set.friction, &set.coefficient})
      csv += "," + csvField(*text);
    csv += (set.speed ? settingField(asMillimeters(*set.speed)) : ",") + "," +
           csvField(set.opening) + settingField(asDegrees(set.approachTilt)) +
           settingField(asDegrees(set.approachTurn)) + "," + std::to_string(set.seed) +
           settingField(asMillimeters(each.stopTravel)) + nextField(set.stopForce) + "," +
           haptics::nameOf(each.end) + "\n";
  }
  return csv;
}

std::string comparisonDictionaryCsv() { return dictionaryCsv(comparisonColumns()); }

std::string curvesCsv(const std::vector<ComparedInsertion>& insertions, CurveAxis axis)
{
  std::string csv = axis == CurveAxis::travel  ? "travel_mm"
                    : axis == CurveAxis::depth ? "depth_mm"
                                               : "angle_deg";
  const double spacing = stepOf(axis);
  std::map<long, std::vector<double>> rows;
  const double missing = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < insertions.size(); ++i) {
    csv += "," + csvField(labelOf(insertions[i]) + "_N");
    for (const AxisPoint& point : curveOver(insertions[i], axis)) {
      auto& row = rows[std::lround(point.place / spacing)];
      row.resize(insertions.size(), missing);
      row[i] = point.force;
    }
  }
  csv += "\n";
  for (const auto& [step, forces] : rows) {
    csv += session::shortestDecimal(inFile(axis, static_cast<double>(step) * spacing));
    for (const double force : forces)
      csv += std::isnan(force) ? std::string(",") : nextField(force);
    csv += "\n";
  }
  return csv;
}

std::string eventsCsv(const std::vector<ComparedInsertion>& insertions)
{
  std::string csv = headerOf(eventColumns()) + "\n";
  for (const ComparedInsertion& each : insertions)
    for (const InsertionEvent& event : each.events)
      csv += csvField(labelOf(each)) + "," + nameOf(event.kind) + "," +
             (event.number > 0 ? std::to_string(event.number) : std::string()) +
             nextField(event.time) + nextField(asMillimeters(event.travel)) +
             nextField(asMillimeters(event.depth)) + nextField(asDegrees(event.angle)) +
             nextField(event.force) + "\n";
  return csv;
}

bool areComparableWithPublished(const std::vector<ComparedInsertion>& insertions)
{
  const auto hasArrayOfFirst = [&](const ComparedInsertion& each) {
    return each.subject.array == insertions.front().subject.array;
  };
  return std::ranges::any_of(insertions, &ComparedInsertion::hasPublishedConditions) &&
         std::ranges::all_of(insertions, hasArrayOfFirst);
}

std::optional<double> forceAt(const std::vector<AxisPoint>& curve, double place)
{
  if (curve.empty() || place < curve.front().place || place > curve.back().place)
    return std::nullopt;
  const auto after = std::ranges::lower_bound(curve, place, {}, &AxisPoint::place);
  if (after == curve.begin() || after->place == place) return after->force;
  const AxisPoint& before = *std::prev(after);
  const double fraction = (place - before.place) / (after->place - before.place);
  return before.force + fraction * (after->force - before.force);
}

void tellApart(std::vector<ComparedInsertion>& insertions)
{
  std::set<std::string> taken;
  for (std::size_t i = 0; i < insertions.size(); ++i) {
    const std::string own = insertions[i].name;
    for (std::size_t number = i + 1; !taken.insert(labelOf(insertions[i])).second; ++number)
      insertions[i].name = own + " (" + std::to_string(number) + ")";
  }
}

}  // namespace perilymph::analysis
