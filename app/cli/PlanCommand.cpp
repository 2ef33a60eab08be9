// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <filesystem>
#include <stop_token>

#include "CommandFiles.h"
#include "Commands.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "PatientOption.h"
#include "PlanOptions.h"
#include "Terminal.h"
#include "perilymph/analysis/ClinicalReports.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/UtcTime.h"
#include "perilymph/planning/ContactsCsv.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlanFolder.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/planning/PlanWords.h"
#include "perilymph/planning/PlannedDraw.h"
#include "perilymph/planning/ResistanceGrid.h"

namespace perilymph::cli {

namespace {

Result<planning::PlanRequest> requestOf(const PlanOptions& options)
{
  const std::size_t samples =
      options.samples.value_or(planning::usualDraws(options.clinicResistance.has_value()));
  if (const auto done = planning::checkDraws(samples); !done) return done.error();
  const auto patient = readPatient(options.patient);
  if (!patient) return patient.error();
  planning::PlanRequest request;
  request.patient = *patient;
  const bool isAll =
      options.arrays.empty() || (options.arrays.size() == 1 && options.arrays.front() == "all");
  request.arrays = isAll ? shippedNames("plugins/electrodes") : options.arrays;
  if (request.arrays.size() > maxPlanArrays)
    return Error{std::to_string(request.arrays.size()) + " arrays are too many; a plan compares " +
                 std::to_string(maxPlanArrays) + " at most. Name fewer."};
  request.friction = options.friction;
  request.clinicResistance = options.clinicResistance;
  request.draws = samples;
  request.stopsEarly = !options.runsAll;
  request.seed = options.seed;
  request.jobs = options.jobs;
  return request;
}

std::string bandText(const planning::Band& band, int decimals)
{
  return fixed(band.median, decimals) + " (" + fixed(band.low, decimals) + " to " +
         fixed(band.high, decimals) + ")";
}

/// The arrays at the end of their median draws: `array, draw, node, x, y, z`, a row per node from the
/// base to the tip, in the cochlear frame.
Result<std::string> shapesCsv(const planning::Plan& plan, const std::stop_token& stop)
{
  const auto ends = planning::representativeEnds(plan, stop);
  if (!ends) return ends.error();
  std::string csv = headerOf(planning::shapeColumns()) + "\n";
  for (std::size_t i = 0; i < ends->size(); ++i) {
    std::size_t node = 0;
    for (const auto& node_W : (*ends)[i].node_W) {
      csv += csvField(plan.arrays[i].array) + "," + std::to_string((*ends)[i].draw) + "," +
             std::to_string(++node);
      for (const float place : node_W)
        csv += "," + fixed(inMillimeters(meters(static_cast<double>(place))), 4);
      csv += '\n';
    }
  }
  return csv;
}

/// "clinics report 408 (quartiles 373 to 449) deg, n = 48 of FLEX24 + FLEX28 + Standard
/// (O'Connell 2017)" below a simulated value.
void printReported(const std::string& array, analysis::ReportedQuantity quantity, const char* unit)
{
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  const analysis::ClinicalReport* report = evidence ? evidence->find(array, quantity) : nullptr;
  if (report == nullptr) return;
  std::string ears = report->n > 0 && !report->count ? ", n = " + std::to_string(report->n) : "";
  if (const std::string& of = report->valueOf.empty() ? report->nOf : report->valueOf; !of.empty())
    ears += (ears.empty() ? ", of " : " of ") + of;
  print("    clinics report         {}{}{} ({})\n", numbersOf(*report),
        report->count ? "" : std::string(" ") + unit, ears, report->reference);
}

void printArray(const planning::ArrayPlan& array)
{
  const auto counted = [&array](const analysis::Estimate& estimate) {
    return analysis::shareText(estimate, array.draws);
  };
  print("{}, {} {}\n", array.name, array.draws, array.draws == 1 ? "simulation" : "simulations");
  using analysis::ReportedQuantity;
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  if (evidence && evidence->verdictOf(array.array) == analysis::ArrayVerdict::notTested)
    print("  not tested: the clinical table has no row of it\n");
  if (evidence)
    for (const std::string& row : evidence->missedRows(array.array))
      print("  not validated: the clinical table misses {}\n", row);
  print("  angular insertion depth  {} deg\n", bandText(array.angle_deg, 0));
  printReported(array.array, ReportedQuantity::angle, "deg");
  if (array.atMedianFriction)
    print("    at the median friction {} deg\n", bandText(array.atMedianFriction->angle_deg, 0));
  if (array.inClinic)
    print("  depth in this clinic     {} mm, {} effective simulations\n",
          bandText(array.inClinic->depth_mm, 1), fixed(array.inClinic->effective, 0));
  print("  cochlear coverage        {} %\n", bandText(array.coverage_percent, 0));
  print("  peak insertion force     {} mN\n", bandText(array.peak_mN, 1));
  if (array.atMedianFriction)
    print("    at the median friction {} mN\n", bandText(array.atMedianFriction->peak_mN, 1));
  printReported(array.array, ReportedQuantity::peakForce, "mN");
  print("  end force                {} mN\n", bandText(array.end_mN, 1));
  printReported(array.array, ReportedQuantity::endForce, "mN");
  print("  after 1 s of rest        {} mN\n", bandText(array.after1s_mN, 1));
  print("  after 10 s of rest       {} mN\n", bandText(array.after10s_mN, 1));
  print("  force on the partition   {} mN\n", bandText(array.partition_mN, 2));
  print("  first resistance         {} mm\n", bandText(array.firstResistance_mm, 1));
  print("  all contacts inside      {}\n", counted(array.allInside));
  printReported(array.array, ReportedQuantity::complete, "%");
  print("  intended depth reached   {}\n", counted(array.full));
  print("  stopped by resistance    {}\n", counted(array.resisted));
  print("  buckled                  {}\n", counted(array.buckled));
  print("  tip folded over          {}\n", counted(array.foldedTip));
  printReported(array.array, ReportedQuantity::foldOver, "%");
  print("  translocated             {}\n", counted(array.translocated));
  printReported(array.array, ReportedQuantity::translocation, "%");
}

}  // namespace

Result<void> plan(const PlanOptions& options, const CommandFiles& files)
{
  const auto request = requestOf(options);
  if (!request) return request.error();
  if (const auto done = checkFolder(options.out); !done) return done.error();
  std::error_code failure;
  const bool isOwn = std::filesystem::exists(std::filesystem::symlink_status(
      std::filesystem::path(options.out) / planning::planDrawsFile, failure));
  if (const auto done = checkReplaced(options.out, planFiles(), isOwn); !done) return done.error();
  std::filesystem::create_directories(options.out, failure);
  if (failure)
    return Error{options.out + " cannot be created: " + failure.message() +
                 ". Give another folder."};
  const std::stop_token stop = watchForInterruption();
  const auto plan = planning::makePlan(
      *request, std::filesystem::path(options.out) / planning::planDrawsFile,
      [](std::size_t done, std::size_t all) { showProgress("insertion", done, all); }, stop);
  if (isInterrupted())
    return Error{"Interrupted; what was done is kept. The same command continues."};
  if (!plan) return plan.error();
  const auto json = planning::planJson(*plan);
  if (!json) return json.error();

  const auto shapes = shapesCsv(*plan, stop);
  if (!shapes) return shapes.error();

  FolderContent content;
  content.texts = {{planning::planJsonFile, *json},
                   {"arrays.csv", planning::arraysCsv(*plan)},
                   {"contacts.csv", planning::contactsCsv(*plan)},
                   {"contacts-dictionary.csv", planning::contactsDictionaryCsv()},
                   {"differences.csv", planning::differencesCsv(*plan)},
                   {"shapes.csv", *shapes}};
  // the window opens a plan by these
  const auto asked = planning::requestFiles(
      {options.out, *request, plan->insertions.size() / request->arrays.size(), true, utcNow()});
  content.texts.insert(content.texts.begin(), asked.begin(), asked.end());
  for (const auto& [name, figure] : planning::planFigures(*plan))
    content.figures.emplace_back(name, figures::draw(figure));
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  print(
      "Median ({}) of what measures, shape, hand, friction, approach, stiffness and wires leave "
      "open; "
      "shares as n of N, "
      "from {} simulations on in percent with 95 % intervals.\n"
      "For research and training; not a medical device.\n",
      planning::bandsHold(*plan), analysis::fewestForPercent);
  if (plan->clinic) print("{}\n", planning::clinicSentence(*plan->clinic));
  for (const planning::ArrayPlan& array : plan->arrays) {
    printArray(array);
    if (plan->clinic && !array.inClinic)
      print("  depth in this clinic: fewer than {} effective simulations; raise --samples\n",
            fixed(planning::fewestEffective, 0));
  }
  if (!plan->differences.empty())
    print("Differences in the same ear, with the same hand and friction:\n");
  for (const planning::ArrayDifference& each : plan->differences)
    print("  {} - {}: angle {} deg, peak {} mN; deeper in {}\n", plan->arrays[each.first].name,
          plan->arrays[each.second].name, bandText(each.angle_deg, 0), bandText(each.peak_mN, 1),
          analysis::shareText(each.deeper, each.draws));
  return {};
}

}  // namespace perilymph::cli
