// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <optional>

#include "CommandFiles.h"
#include "Commands.h"
#include "Interruption.h"
#include "LiveBroadcast.h"
#include "PatientOption.h"
#include "Terminal.h"
#include "perilymph/analysis/PublishedConditions.h"
#include "perilymph/analysis/SimulatedInsertion.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::cli {

namespace {

/// Output of CSV rows, if requested.
struct CsvRows {
  std::ofstream stream;
  session::CsvPeriod period{0.0};
};

/// What the user can change after an early end.
const char* adviceFor(haptics::InsertionEnd end)
{
  switch (end) {
    case haptics::InsertionEnd::buckled:
    case haptics::InsertionEnd::outOfOpening:
      return " Align the array with the opening (approach_tilt_deg, approach_turn_deg), reduce "
             "friction, or choose a stiffer array.";
    case haptics::InsertionEnd::foldedTip:
      return " Change the approach (approach_tilt_deg, approach_turn_deg) or the technique.";
    case haptics::InsertionEnd::jammed:
      return " Lower stop_travel_mm, reduce friction, or choose a thinner array.";
    default:
      return "";
  }
}

using Outcome = analysis::SimulatedInsertion;

Result<Outcome> run(session::Insertion& insertion, CsvRows* rows, LiveBroadcast* live)
{
  const auto outcome = analysis::simulate(insertion, [&](const haptics::TickRecord& record) {
    if (live != nullptr) live->show(record);
    if (rows && rows->period.keeps(record.output.time)) rows->stream << session::csvRow(record);
    return !isInterrupted();
  });
  if (isInterrupted())
    return insertion.recording()
               ? Error{"Interrupted; only the recording was kept, as far as it came."}
               : Error{"Interrupted; nothing was written."};
  return outcome;
}

/// Runs the insertion and writes the rows to a file, atomically at the end of the run.
Result<Outcome> runIntoCsv(session::Insertion& insertion, const SimulateOptions& options,
                           LiveBroadcast* live)
{
  std::optional<Result<Outcome>> outcome;
  const auto written = writeWhole(options.csv, [&](const std::filesystem::path& place) {
    CsvRows rows;
    rows.period = session::CsvPeriod(options.every_ms / 1e3);
    rows.stream.open(place, std::ios::binary);
    rows.stream << session::csvHeader();
    outcome = run(insertion, &rows, live);
    rows.stream.close();
    return rows.stream.good() && static_cast<bool>(*outcome);
  });
  if (outcome && !*outcome) return outcome->error();
  if (!written) return written.error();
  return *outcome;
}

void printPoint(const char* name, const std::optional<analysis::CurvePoint>& point)
{
  if (point)
    print("{:18} {} mN at {} mm travel\n", name, fixed(inMillinewtons(newtons(point->force)), 1),
          fixed(inMillimeters(meters(point->travel)), 1));
}

/// What happened to the cochlear partition, if it ruptured.
void printPartition(const haptics::TickOutput& last)
{
  if ((last.status & haptics::partitionRuptured) == 0) return;
  const haptics::Translocation& found = last.translocation;
  print("{:18} at {} deg under {} mN, {} mm deep; ", "partition ruptured",
        fixed(inDegrees(radians(found.angle)), 1), fixed(inMillinewtons(newtons(found.force)), 1),
        fixed(inMillimeters(meters(found.depth)), 2));
  if ((last.status & haptics::translocated) != 0)
    print("translocated: {} mm of the array are in the scala vestibuli\n",
          fixed(inMillimeters(meters(found.lengthAbove)), 1));
  else
    print("no part of the array is in the scala vestibuli\n");
}

void printSummary(const session::Scenario& scenario, const Outcome& outcome)
{
  const analysis::ForceProfile& profile = outcome.profile;
  print("{}: {} samples, {} s, array {}\n", scenario.name(), profile.ticks,
        fixed(profile.duration, 3), scenario.array().name);
  for (const std::string& note : scenario.notes()) print("{}\n", note);
  const haptics::InsertionEnd end = endOf(outcome.last);
  if (end != haptics::InsertionEnd::finished)
    print("{:18} the array {}, {}.{}\n", nameOf(end), clauseOf(end),
          analysis::placeOf(outcome.last), adviceFor(end));
  printPartition(outcome.last);
  printPoint("peak force", profile.peak);
  if (const auto& passed = outcome.passedStop)
    print(
        "{:18} a hand that stops at {} mN would have ended at {} mm, {} deg, {} of {} contacts "
        "inside\n",
        "force passed", fixed(inMillinewtons(passed->stop), 0),
        fixed(inMillimeters(passed->depth), 1), fixed(inDegrees(passed->apical), 0), passed->inside,
        passed->contacts);
  if (analysis::hasPublishedBasalTurn(scenario)) {
    printPoint("basal-turn peak", profile.basalTurnPeak);
    printPoint("following dip", profile.basalTurnDip);
  }
  print(
      "{:18} travel {} mm, insertion depth {} mm, angular insertion depth {} deg, tip angle {} "
      "deg\n",
      "at the end", fixed(inMillimeters(meters(profile.finalTravel)), 2),
      fixed(inMillimeters(meters(profile.finalDepth)), 2),
      fixed(inDegrees(outcome.angularInsertionDepth), 1),
      fixed(inDegrees(radians(profile.finalAngle)), 1));
  print("{:18} {} mJ\n", "insertion work", fixed(profile.work * 1e3, 4));
  if (profile.ticksNotConverged > 0)
    print("{:18} {} samples: solver residual above tolerance\n", "not converged",
          profile.ticksNotConverged);
}

}  // namespace

Result<void> simulate(const SimulateOptions& options, const CommandFiles& files)
{
  const auto scenario = session::loadScenario(options.scenario, options.overrides);
  if (!scenario) return scenario.error();
  if (const auto done = files.checkScenarioFiles(scenario->files()); !done) return done.error();
  printNoteOn(scenario->patient());

  std::optional<std::filesystem::path> record;
  if (!options.record.empty()) record = options.record;
  auto device =
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si());
  watchForInterruption();
  auto insertion = session::Insertion::prepare(*scenario, std::move(device), record);
  if (!insertion) return insertion.error();

  std::unique_ptr<LiveBroadcast> live;
  if (!options.igtl.empty()) {
    auto started = LiveBroadcast::start(options.igtl, **insertion);
    if (!started) return started.error();
    live = *std::move(started);
  }
  const auto outcome = options.csv.empty() ? run(**insertion, nullptr, live.get())
                                           : runIntoCsv(**insertion, options, live.get());
  if (!outcome) return outcome.error();
  if (!options.json.empty()) {
    const auto done = writeWhole(
        options.json,
        analysis::simulationJson(*scenario, *outcome, (*insertion)->loop().statistics()));
    if (!done) return done.error();
  }
  printSummary(*scenario, *outcome);

  // The run succeeded, but an error of its recording must still be reported.
  if (const auto done = (*insertion)->closeRecording(); !done) return done.error();
  return {};
}

}  // namespace perilymph::cli
