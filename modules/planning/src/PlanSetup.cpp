// SPDX-License-Identifier: BSD-3-Clause
#include "PlanSetup.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <stop_token>
#include <utility>

#include "FrequencyAllocation.h"
#include "PlanNames.h"
#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/analysis/Reference.h"
#include "perilymph/electrode/WirePacking.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/session/Csv.h"

namespace perilymph::planning {

namespace {

/// Every value of a scenario, without the places of the files that it names: their numbers and the fingerprint
/// of the array are among the values, so that a plan is the same wherever its files are.
std::string contentOf(const session::Scenario& scenario)
{
  std::string text = bareName(scenario.arrayName()) + "\n";
  for (const auto& [key, value] : scenario.values())
    if (key != "array" && key != "friction" && key != "calibration")
      text += key + " = " + value + "\n";
  return text;
}

Result<void> addArray(PlanSetup& setup, const PlanRequest& request, const std::string& array,
                      const std::vector<FrequencyAllocation>& allocations)
{
  const auto scenario = scenarioOf(request, array, session::anyStopTravel);
  if (!scenario) return Error{"%1: %2", array, scenario.error().message};
  const electrode::ArrayDesign& design = scenario->array();
  Nominal nominal{scenario->parameters(), contentOf(*scenario),
                  setup.uncertainty.stiffnessOf(design)};
  session::InsertionParameters& parameters = nominal.parameters;
  parameters.withdraws = false;
  parameters.cochlea.source = anatomy::AnatomySource::mean;
  parameters.stopTravel = session::fullTravel(parameters.array, parameters.startInside);
  if (!(parameters.stopTravel.si() > 0.0))
    return Error{"The array %1 starts at its full depth. Lower start_inside_mm.", design.name};
  parameters.engine.stopTravel = parameters.stopTravel.si();
  setup.arrays.push_back({design.name, filtersOf(design, allocations)});
  setup.nominal.push_back(std::move(nominal));
  return {};
}

/// SHA-256 of the files from which the draws come.
Result<std::string> distributionsHash()
{
  Sha256 hash;
  for (const std::filesystem::path& file :
       {shippedUncertaintyFile(), analysis::shippedHandFile(), analysis::shippedPackingFile()}) {
    const auto text = readWhole(file);
    if (!text) return text.error();
    hash.add(std::uint64_t{text->size()});
    hash.add(*text);
  }
  return hash.hex();
}

Result<void> checkRequest(const PlanRequest& request)
{
  if (!request.patient.basalTurn)
    return Error{
        "The patient %1 has no A and B, which a plan needs. Measure them, or use 'simulate'.",
        request.patient.label};
  if (request.arrays.empty()) return Error{"A plan needs at least one array. Name one."};
  for (auto each = request.arrays.begin(); each != request.arrays.end(); ++each)
    if (std::find(request.arrays.begin(), each, *each) != each)
      return Error{"The array %1 is named twice. Name it once.", *each};
  if (request.draws < 1 || request.draws > maxDraws)
    return Error{"A plan of %1 draws is not possible; 1 to %2 are.", request.draws, maxDraws};
  return {};
}

/// Reads the clinic's resistance that a request asks for.
Result<void> readClinic(PlanSetup& setup, const PlanRequest& request)
{
  if (!request.clinicResistance) return {};
  auto clinic = loadClinicResistance(*request.clinicResistance);
  if (!clinic) return clinic.error();
  const session::InsertionParameters& parameters = setup.nominal.front().parameters;
  if (!parameters.frictionSpread.isKnown())
    return Error{
        "The friction of this plan states no spread, so that %1 cannot be used. Choose a friction "
        "with a spread, or plan without the clinic's resistance.",
        *request.clinicResistance};
  constexpr double sixDigits = 1e-5;
  const double friction = parameters.friction.staticCoefficient;
  if (std::fabs(friction - clinic->friction) > sixDigits * friction)
    return Error{
        "%1 counts from the friction %2, and this plan has %3. Choose the friction that the "
        "clinic's plans had.",
        *request.clinicResistance, session::shortestDecimal(clinic->friction),
        session::shortestDecimal(friction)};
  setup.clinic = *std::move(clinic);
  return {};
}

PlannedInsertion plannedOf(const PlanDraw& draw, double stiffness, std::size_t number,
                           std::size_t array)
{
  PlannedInsertion planned;
  planned.draw = number;
  planned.array = array;
  const anatomy::BasalTurn& turn = *draw.patient.basalTurn;
  planned.a_mm = inMillimeters(turn.a);
  planned.b_mm = inMillimeters(turn.b);
  planned.h_mm = turn.h ? inMillimeters(*turn.h) : 0.0;
  planned.a1_deviate = draw.sharing[0];
  planned.b1_deviate = draw.sharing[1];
  const auto at = [](double angle_deg) { return degrees(angle_deg).si(); };
  const anatomy::IndividualShape& shape = draw.shape;
  planned.section = shape.sectionAt(at(90.0));
  planned.sectionSecond = shape.sectionAt(at(450.0));
  const double middle = 0.5 * (shape.course.at(at(0.0)) + shape.course.at(at(180.0)));
  planned.dip_mm = inMillimeters(meters(shape.course.at(at(90.0)) - middle));
  planned.radius = 1.0 + shape.radius.at(at(180.0));
  planned.height = shape.height;
  planned.lining_mm = inMillimeters(draw.lining);
  planned.membrane_N_m = draw.membrane.si();
  planned.tilt_deg = inDegrees(draw.tilt);
  planned.turn_deg = inDegrees(draw.turn);
  planned.stiffness = stiffness;
  planned.friction = draw.surgeon.frictionFactor;
  planned.speed_mm_s = inMillimetersPerSecond(draw.surgeon.speed);
  planned.stop_mN = inMillinewtons(draw.surgeon.stop);
  planned.free_mm = inMillimeters(draw.surgeon.freeLength);
  return planned;
}

/// The cochlea of a draw, which all arrays of the plan share: its lead-in is the first array's.
Result<std::shared_ptr<const anatomy::ScalaTympani>> buildCochlea(const PlanSetup& setup,
                                                                  const PlanDraw& draw)
{
  try {
    return anatomy::buildMean(draw.patient.label, *draw.patient.basalTurn, draw.shape,
                              setup.nominal.front().parameters.cochlea.leadIn);
  } catch (const std::invalid_argument& error) {
    return Error{"A cochlea of %1 cannot be built: %2. Check A and B and their errors.",
                 draw.patient.label, error.what()};
  }
}

std::vector<std::array<float, 3>> nodesOf(const haptics::Snapshot& shown)
{
  return {shown.node_W.begin(), shown.node_W.begin() + shown.nodes};
}

/// One array in a draw.
///
/// @param shape  Receives parameters and the array at the end; its cochlea is built if empty.
Result<PlannedInsertion> insertArray(const PlanRequest& request, const PlanSetup& setup,
                                     const PlanDraw& draw, std::size_t number, std::size_t array,
                                     Length profileSpacing, PlannedShape& shape,
                                     const std::stop_token& stop)
{
  const Nominal& nominal = setup.nominal[array];
  const double stiffness = stiffnessFactor(draw, nominal.stiffnessDeviation);
  shape.parameters = drawnParameters(nominal.parameters, draw, stiffness, request.resolution);
  if (!shape.anatomy) {
    auto built = buildCochlea(setup, draw);
    if (!built) return built.error();
    shape.anatomy = *std::move(built);
  }
  PlannedInsertion planned = plannedOf(draw, stiffness, number, array);
  if (electrode::wirePacking(nominal.parameters.array)) planned.packing = draw.packing;
  if (nominal.parameters.array.taper) {
    const electrode::ArrayDesign& drawn = shape.parameters.array;
    planned.lastContact_mm = inMillimeters(drawn.diameter.at(drawn.contactsFromTip.back()));
  }
  planned.intended_mm = inMillimeters(analysis::intendedDepth(shape.parameters, draw.surgeon));
  planned.insertion = analysis::asPossible(analysis::insertByHand(
      shape.parameters, shape.anatomy, setup.hand, draw.surgeon, profileSpacing, stop, &shape.end));
  if (planned.insertion.end != haptics::InsertionEnd::refused) planned.end_W = nodesOf(shape.end);
  return planned;
}

PlanDraw drawOf(const PlanRequest& request, const PlanSetup& setup, std::size_t number)
{
  return drawPlan(request.patient, setup.uncertainty, setup.hand, request.seed, number,
                  setup.nominal.front().parameters.frictionSpread);
}

}  // namespace

Result<PlanSetup> preparePlan(const PlanRequest& request)
{
  if (const auto done = checkRequest(request); !done) return done.error();
  const auto uncertainty = shippedUncertainty();
  if (!uncertainty) return uncertainty.error();
  const auto hand = analysis::shippedHand();
  if (!hand) return hand.error();
  const auto felt = analysis::forceFeltBySurgeons();
  if (!felt) return felt.error();
  const auto allocations = shippedAllocations();
  if (!allocations) return allocations.error();
  const auto distributions = distributionsHash();
  if (!distributions) return distributions.error();
  PlanSetup setup{*uncertainty,   *hand, {*felt, hand->ruptureLow, hand->ruptureHigh},
                  *distributions, {},    {}};
  for (const std::string& array : request.arrays)
    if (const auto added = addArray(setup, request, array, *allocations); !added)
      return added.error();
  if (const auto done = readClinic(setup, request); !done) return done.error();
  return setup;
}

Range frictionOf(const PlanSetup& setup)
{
  const mechanics::FrictionLaw& law = setup.nominal.front().parameters.friction;
  Range range{std::min(law.staticCoefficient, law.kineticCoefficient),
              std::max(law.staticCoefficient, law.kineticCoefficient)};
  if (!law.bySpeed.isEmpty())
    range = {std::min(law.staticCoefficient, law.bySpeed.minimum()),
             std::max(law.staticCoefficient, law.bySpeed.maximum())};
  return range;
}

double frictionSpreadOf(const PlanSetup& setup)
{
  const session::FrictionSpread& spread = setup.nominal.front().parameters.frictionSpread;
  return std::sqrt(spread.shared * spread.shared + spread.ear * spread.ear);
}

std::string fingerprintOf(const PlanRequest& request, const PlanSetup& setup)
{
  Sha256 hash;
  const auto add = [&hash](const std::string& text) {
    hash.add(std::to_string(text.size()) + ":" + text);
  };
  add("plan 7");
  if (const auto& resolution = request.resolution) {
    add(std::to_string(resolution->nodes));
    add(session::shortestDecimal(resolution->step.si()));
  }
  add(std::to_string(request.seed));
  add(anatomy::patientText(request.patient));
  add(setup.distributions);
  for (const Nominal& each : setup.nominal) add(each.text);
  // what the summary is compared with: a changed one shows other numbers of the same insertions
  for (const Force force :
       {setup.thresholds.felt, setup.thresholds.ruptureLow, setup.thresholds.ruptureHigh})
    add(session::shortestDecimal(force.si()));
  for (const PlannedArray& each : setup.arrays)
    for (const double filter_Hz : each.filter_Hz) add(session::shortestDecimal(filter_Hz));
  if (setup.clinic) add("clinic " + setup.clinic->number);
  return hash.hex();
}

void addClinic(Plan& plan, const PlanSetup& setup)
{
  if (!setup.clinic) return;
  const ClinicResistance& clinic = *setup.clinic;
  plan.clinic = ClinicSource{clinic.number,        clinic.resisted,  clinic.censored,
                             clinic.uninformative, clinic.firstYear, clinic.lastYear};
  for (std::size_t array = 0; array < plan.arrays.size(); ++array) {
    StopDraws draws;
    draws.logFrictionSd = frictionSpreadOf(setup);
    for (const PlannedInsertion& each : plan.insertions) {
      if (each.array != array || each.stop_mm.size() != stopShifts) continue;
      StopDraw draw{logarithm(each.friction), each.intended_mm, each.push_mm, each.isPushedFully};
      std::copy(each.stop_mm.begin(), each.stop_mm.end(), draw.stop_mm.begin());
      draws.draws.push_back(draw);
    }
    if (draws.draws.empty()) continue;
    const WeightedDepths depths = depthsIn(clinic.cells, draws);
    if (depths.effective >= fewestEffective)
      plan.arrays[array].inClinic = InClinic{depths.band(), depths.effective};
  }
}

Result<std::vector<PlannedInsertion>> runDraw(const PlanRequest& request, const PlanSetup& setup,
                                              std::size_t number, const std::stop_token& stop)
{
  const PlanDraw draw = drawOf(request, setup, number);
  PlannedShape shape;
  std::vector<PlannedInsertion> insertions;
  for (std::size_t i = 0; i < setup.nominal.size() && !stop.stop_requested(); ++i) {
    auto planned = insertArray(request, setup, draw, number, i, bandSpacing, shape, stop);
    if (!planned) return planned.error();
    if (setup.clinic && !stop.stop_requested() &&
        planned->insertion.end != haptics::InsertionEnd::refused) {
      const auto unstopped = runWithoutStop(request, setup, i, number, stop);
      if (!unstopped) return unstopped.error();
      const StopDraw stops = stopDrawOf(*unstopped);
      planned->push_mm = stops.end_mm;
      planned->isPushedFully = stops.isFull;
      planned->stop_mm.assign(stops.stop_mm.begin(), stops.stop_mm.end());
    }
    insertions.push_back(*std::move(planned));
  }
  return insertions;
}

Result<std::shared_ptr<const anatomy::ScalaTympani>> cochleaOf(const PlanRequest& request,
                                                               const PlanSetup& setup,
                                                               std::size_t number)
{
  return buildCochlea(setup, drawOf(request, setup, number));
}

Result<PlannedShape> runShape(const PlanRequest& request, const PlanSetup& setup, std::size_t array,
                              std::size_t number, const std::stop_token& stop,
                              std::shared_ptr<const anatomy::ScalaTympani> cochlea)
{
  const PlanDraw draw = drawOf(request, setup, number);
  PlannedShape shape;
  shape.anatomy = std::move(cochlea);
  auto planned = insertArray(request, setup, draw, number, array, traceSpacing, shape, stop);
  if (!planned) return planned.error();
  shape.insertion = *std::move(planned);
  return shape;
}

Result<UnstoppedDraw> runWithoutStop(const PlanRequest& request, const PlanSetup& setup,
                                     std::size_t array, std::size_t number,
                                     const std::stop_token& stop)
{
  const PlanDraw draw = drawOf(request, setup, number);
  const Nominal& nominal = setup.nominal[array];
  const auto parameters =
      drawnParameters(nominal.parameters, draw, stiffnessFactor(draw, nominal.stiffnessDeviation),
                      request.resolution);
  const auto anatomy = buildCochlea(setup, draw);
  if (!anatomy) return anatomy.error();
  return UnstoppedDraw{
      number, draw.surgeon.frictionFactor, draw.surgeon.stop,
      analysis::intendedDepth(parameters, draw.surgeon),
      analysis::pushWithoutStop(parameters, *anatomy, setup.hand, draw.surgeon, stop)};
}

}  // namespace perilymph::planning
