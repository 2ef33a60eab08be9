// SPDX-License-Identifier: BSD-3-Clause
#include "prediction/PhantomRows.h"

#include <cmath>
#include <stop_token>
#include <string>

#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "prediction/VirtualInsertion.h"

namespace perilymph::validation {

namespace {

constexpr const char* phantomSource =
    "\"The role of pressure and friction forces in automated insertion of cochlear implants\" "
    "(Front Neurol, abstract): FLEX28, one mean scala tympani coiled and uncoiled, 0.125 to 2 "
    "mm/s, "
    "soap (SDS) of 1, 5 and 10 %";
constexpr Length phantomStart = millimeters(1);
/// FLEX28 with soap: 1 and 5 ms differ by less than 1 %.
constexpr Duration phantomStep = milliseconds(5);

/// A phantom is rigid, drilled as the duct is, and the machine guides the array to its opening.
Result<session::Scenario> machineInsertion(const std::string& friction, const std::string& speed)
{
  return fullInsertionOf("surgery-flex28", "flex28", phantomStart, phantomStep,
                         {{"friction", friction}, {"membrane", "rigid"}, {"speed_mm_s", speed}});
}

struct Phantom {
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  std::stop_token stop;

  /// Maximum force of one insertion [mN].
  Result<double> peak(const std::string& friction, const std::string& speed)
  {
    const auto scenario = machineInsertion(friction, speed);
    if (!scenario) return scenario.error();
    const analysis::InsertionRun full =
        analysis::runInsertion(scenario->parameters(), anatomy, Length{}, stop);
    return inMillinewtons(full.peak.force);
  }
};

ClinicalRow phantomRow(const char* quantity, const char* unit, double low, double high,
                       double value)
{
  ClinicalRow row;
  row.quantity = quantity;
  row.unit = unit;
  row.low = low;
  row.high = high;
  row.median = row.lowerQuartile = row.upperQuartile = value;
  row.runs = 1;
  row.isClinical = false;
  row.confidence = "medium";
  row.source = phantomSource;
  row.inside = value >= low && value <= high ? 1.0 : 0.0;
  row.verdict = row.inside > 0.0 ? RowVerdict::hit : RowVerdict::miss;
  return row;
}

/// Force of fluid and weight on an array in a straight duct, which it touches along its bottom: the
/// steady motion of the model without a bend [mN].
Result<double> straightForce(const session::Scenario& scenario,
                             std::shared_ptr<const anatomy::ScalaTympani> anatomy)
{
  const auto model = session::buildModel(scenario.parameters(), std::move(anatomy));
  if (!model) return model.error();
  constexpr double gravity = 9.81;  // [m/s^2]
  double drag = 0.0, mass = 0.0;
  for (const double each : (*model)->drag) drag += each;
  for (const double each : (*model)->mass) mass += each;
  const double speed = scenario.parameters().speed.si();
  return 1e3 * (drag * speed + mass * gravity * scenario.parameters().friction.sliding(speed));
}

/// The relative change of the peak from 0.125 to 2 mm/s [%].
Result<double> speedEffect(Phantom& phantom, const char* friction)
{
  const auto slow = phantom.peak(friction, "0.125");
  if (!slow) return slow.error();
  const auto fast = phantom.peak(friction, "2.0");
  if (!fast) return fast.error();
  return 100.0 * (*fast - *slow) / *slow;
}

}  // namespace

Result<std::vector<ClinicalRow>> phantomRows(const std::stop_token& stop)
{
  const auto scenario = machineInsertion("paper", "1.0");
  if (!scenario) return scenario.error();
  const auto anatomy = session::buildAnatomy(scenario->parameters());
  if (!anatomy) return anatomy.error();
  Phantom phantom{*anatomy, stop};
  std::vector<ClinicalRow> rows;

  const auto coiled = phantom.peak("paper", "1.0");
  if (!coiled) return coiled.error();
  // within 20 % of the published minimum
  rows.push_back(
      phantomRow("coiled FLEX28: peak force at 1 mm/s", "mN", 0.8 * 28.95, 1.2 * 28.95, *coiled));
  rows.back().note =
      "published 28.95 mN (10 % soap), range of 20 %; full depth, which the abstract does not say, "
      "and the friction measured for soap on Teflon (0.0395) are assumed";
  const auto straight = straightForce(*scenario, *anatomy);
  if (!straight) return straight.error();
  rows.push_back(
      phantomRow("uncoiled FLEX28: force of fluid and weight", "mN", 0.0, 2.0, *straight));
  rows.back().note =
      "published at most 0.049 +- 1.5 mN; computed for a straight duct, not inserted";

  // what is published: with much soap no effect, with less falling, with least rising
  struct Effect {
    const char* friction;
    const char* quantity;
    double low, high;
  };
  constexpr Effect effects[] = {
      {"paper", "change of the peak from 0.125 to 2 mm/s, soap on Teflon", -100.0, 0.0},
      {"soap-10", "the same, soap 10 %", -5.0, 5.0},
      {"soap-50", "the same, soap 50 %", -100.0, 0.0},
      {"soap-90", "the same, soap 90 %", 0.0, 1000.0}};
  for (const Effect& effect : effects) {
    const auto change = speedEffect(phantom, effect.friction);
    if (!change) return change.error();
    rows.push_back(phantomRow(effect.quantity, "%", effect.low, effect.high, *change));
    const bool isInput = std::string(effect.friction) != "paper";
    if (isInput)
      rows.back().source =
          "Froehlich et al. 2024 (doi 10.1371/journal.pone.0295121): sign of the effect of speed";
    rows.back().note = isInput ? "the sign is an input: the friction preset was chosen by it"
                               : "the speed over which this friction falls is a choice";
    rows.back().verdict = isInput ? RowVerdict::notJudged : rows.back().verdict;
  }
  return rows;
}

}  // namespace perilymph::validation
