// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stop_token>

#include "perilymph/analysis/CsvField.h"
#include "perilymph/analysis/PublishedConditions.h"
#include "perilymph/analysis/RoundedTravel.h"
#include "perilymph/session/Csv.h"

namespace perilymph::analysis {

using figures::Figure;
using figures::FigureCurve;
using figures::FigureValues;
namespace ink = figures::ink;

namespace {

/// The multiple of the step at which a point lies.
long stepOf(const CurvePoint& point) { return std::lround(point.travel / profileStep().si()); }

}  // namespace

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
  compared.scenario = recorded->facts().scenarioName;
  compared.subject = session::subjectOf(recorded->facts().scenarioText, file.string());
  if (const auto scenario = session::parseScenario(recorded->facts().scenarioText, file.string()))
    compared.hasPublishedConditions = hasPublishedConditions(*scenario);
  compared.startedUtc = recorded->facts().startedUtc;
  ForceProfiler profiler;
  ReversalCounter reversals;
  MotionCounter motion;
  const auto read = recorded->forEach([&](const haptics::TickRecord& record) {
    profiler.add(record);
    reversals.add(record.output.travel);
    motion.add(record.output);
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
  if (compared.profile.ticks == 0)
    return Error{"%1 contains no samples. Record the insertion to another file.", file};
  return compared;
}

std::string labelOf(const ComparedInsertion& insertion)
{
  return insertion.check.damage.empty() ? insertion.name : insertion.name + " (changed by hand)";
}

std::string comparisonCsv(const std::vector<ComparedInsertion>& insertions)
{
  std::string csv =
      "name,scenario,peak_N,peak_travel_mm,peak_depth_mm,work_mJ,reversals,duration_s,"
      "final_depth_mm,final_angle_deg,rupture_angle_deg,rupture_N,above_mm\n";
  for (const ComparedInsertion& each : insertions) {
    const ForceProfile& profile = each.profile;
    csv += csvField(labelOf(each)) + "," + csvField(each.scenario);
    for (const double value :
         {profile.peak.force, inMillimeters(meters(profile.peak.travel)),
          inMillimeters(meters(profile.peakDepth)), profile.work * 1e3,
          static_cast<double>(each.reversals), profile.duration,
          inMillimeters(meters(profile.finalDepth)), inDegrees(radians(profile.finalAngle))})
      csv += "," + session::shortestDecimal(value);
    if (const auto& found = each.translocation)
      csv += "," + session::shortestDecimal(inDegrees(radians(found->angle))) + "," +
             session::shortestDecimal(found->force) + "," +
             session::shortestDecimal(inMillimeters(meters(found->lengthAbove)));
    else
      csv += ",,,";
    csv += "\n";
  }
  return csv;
}

std::string curvesCsv(const std::vector<ComparedInsertion>& insertions)
{
  std::string csv = "travel_mm";
  std::map<long, std::vector<double>> rows;
  const double missing = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < insertions.size(); ++i) {
    csv += "," + csvField(labelOf(insertions[i]) + "_N");
    for (const CurvePoint& point : insertions[i].profile.curve) {
      auto& row = rows[stepOf(point)];
      row.resize(insertions.size(), missing);
      row[i] = point.force;
    }
  }
  csv += "\n";
  for (const auto& [step, forces] : rows) {
    csv += session::shortestDecimal(
        roundedMillimeters(static_cast<double>(step) * profileStep().si()));
    for (const double force : forces)
      csv += "," + (std::isnan(force) ? std::string() : session::shortestDecimal(force));
    csv += "\n";
  }
  return csv;
}

bool areComparableWithPublished(const std::vector<ComparedInsertion>& insertions)
{
  return std::ranges::any_of(insertions, &ComparedInsertion::hasPublishedConditions);
}

Figure comparisonFigure(const std::vector<ComparedInsertion>& insertions,
                        const Reference* published)
{
  // Distinguished by color and dashes; from the fifth on by longer dashes, too.
  constexpr figures::Ink inks[] = {ink::blue, ink::vermilion, ink::green, ink::purple};
  Figure figure;
  figure.title = Sentence{"Recorded insertions: insertion force over travel"};
  double farthest = 0.0, nearest = 0.0, highest = 0.0, lowest = 0.0;
  for (std::size_t i = 0; i < insertions.size(); ++i) {
    FigureCurve curve;
    curve.label = labelOf(insertions[i]);
    curve.ink = inks[i % 4];
    curve.dash = 2.0 * static_cast<double>(i);
    for (const CurvePoint& point : insertions[i].profile.curve) {
      curve.x.push_back(inMillimeters(meters(point.travel)));
      curve.y.push_back(inMillinewtons(newtons(point.force)));
      nearest = std::min(nearest, curve.x.back());
      farthest = std::max(farthest, curve.x.back());
      lowest = std::min(lowest, curve.y.back());
      highest = std::max(highest, curve.y.back());
    }
    figure.curves.push_back(std::move(curve));
  }
  if (published != nullptr) {
    FigureValues printed;
    printed.label = published->label;
    printed.ink = ink::black;
    printed.shape = figures::MarkerShape::ring;
    for (const PrintedForce& point : published->points) {
      printed.x.push_back(inMillimeters(meters(point.travel)));
      const double mean = inMillinewtons(newtons(point.mean));
      const double deviation = inMillinewtons(newtons(point.standardDeviation));
      printed.y.push_back(mean);
      printed.low.push_back(mean - deviation);
      printed.high.push_back(mean + deviation);
      farthest = std::max(farthest, printed.x.back());
      highest = std::max(highest, printed.high.back());
    }
    figure.values.push_back(std::move(printed));
  }
  figure.x = figures::axisOver(Sentence{"travel, mm"}, nearest, farthest);
  figure.y = figures::axisOver(Sentence{"insertion force, mN"}, lowest, highest);
  return figure;
}

std::optional<double> forceAt(const std::vector<CurvePoint>& curve, double travel)
{
  if (curve.empty() || travel < curve.front().travel || travel > curve.back().travel)
    return std::nullopt;
  const auto after =
      std::lower_bound(curve.begin(), curve.end(), travel,
                       [](const CurvePoint& point, double place) { return point.travel < place; });
  if (after == curve.begin() || after->travel == travel) return after->force;
  const CurvePoint& before = *std::prev(after);
  const double fraction = (travel - before.travel) / (after->travel - before.travel);
  return before.force + fraction * (after->force - before.force);
}

void tellApart(std::vector<ComparedInsertion>& insertions)
{
  for (std::size_t i = 0; i < insertions.size(); ++i)
    for (std::size_t j = i + 1; j < insertions.size(); ++j)
      if (insertions[i].name == insertions[j].name)
        insertions[j].name += " (" + std::to_string(j + 1) + ")";
}

}  // namespace perilymph::analysis
