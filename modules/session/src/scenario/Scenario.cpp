// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Scenario.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "perilymph/anatomy/Approach.h"
#include "perilymph/electrode/WirePacking.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlQuoted.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/session/Csv.h"
#include "scenario/EffectiveText.h"
#include "scenario/ScenarioCalibration.h"
#include "scenario/ScenarioCochlea.h"
#include "scenario/ScenarioFiles.h"
#include "scenario/ScenarioFriction.h"
#include "scenario/ScenarioOpening.h"
#include "scenario/ScenarioRelaxation.h"
#include "scenario/ScenarioWall.h"
#include "scenario/ScenarioYield.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

std::string hexadecimal(std::uint64_t value)
{
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value));
  return digits;
}

// The published number of sample points (Todd and Naghdy, section II.C).
constexpr int publishedPoints = 12;

/// The last override of a key; none if it keeps the file's value.
const std::string* overrideOf(const Overrides& overrides, const char* key)
{
  const auto is = [key](const auto& entry) { return entry.first == key; };
  const auto last = std::find_if(overrides.rbegin(), overrides.rend(), is);
  return last == overrides.rend() ? nullptr : &last->second;
}

/// An array chosen again does not take over the calibration and the yield that a file gives for its own.
void dropFitOfOtherArray(TomlReader& reader, const Overrides& overrides)
{
  const std::string* array = overrideOf(overrides, "array");
  if (array == nullptr || *array == reader.text("array", "contour")) return;
  // a recorded text gives the numbers themselves, too
  for (const char* key : {"calibration", "stiffness_scale", "residual_curvature_fraction",
                          "wire_yield_MPa", "stylet_yield_MPa"})
    if (overrideOf(overrides, key) == nullptr) reader.remove(key);
}

/// A model chosen again does not take over the number of nodes that a file gives for its own.
void dropNodesOfOtherModel(TomlReader& reader, const Overrides& overrides)
{
  const std::string* model = overrideOf(overrides, "model");
  if (model == nullptr || overrideOf(overrides, "nodes") != nullptr || !reader.has("nodes")) return;
  if (*model == reader.text("model", nameOf(mechanics::ModelKind::rod))) return;
  reader.set("nodes", std::to_string(valueIn(modelKinds, *model) == mechanics::ModelKind::points
                                         ? publishedPoints
                                         : InsertionParameters().nodes));
}

void readModel(ScenarioKeys& keys, InsertionParameters& parameters)
{
  parameters.model = keys.choice("model", modelKinds, parameters.model);
  if (parameters.model == mechanics::ModelKind::points) {
    // Two ends make a line; with more points the published model is unstable at 1 kHz.
    parameters.nodes =
        static_cast<int>(keys.integer("nodes", 2, mechanics::maxStablePoints, publishedPoints));
    return;
  }
  // Above 1024 nodes a picture no longer fits its channel; below 8 a rod cannot follow the spiral.
  parameters.nodes = static_cast<int>(keys.integer("nodes", 8, mechanics::maxNodes, 100));
}

void readMotion(ScenarioKeys& keys, InsertionParameters& parameters)
{
  parameters.technique = keys.choice("technique", techniques, parameters.technique);
  // Robots move at 0.1 to 1 mm/s, hands at 0.9, the published rig at 2 (Todd and Naghdy, section
  // II.A; Kesler 2017); a slip of the hand reaches 200.
  parameters.speed = millimetersPerSecond(keys.number("speed_mm_s", {0.01, 200.0}, 2.0));
  // The published rig starts 1 to 3 mm inside. A start in front of the opening is not allowed: there
  // nothing guides the tip into it.
  parameters.startInside = millimeters(keys.number("start_inside_mm", {0.0, 10.0}, 2.0));
  // No array is longer than 31.5 mm (MED-EL Standard).
  parameters.stopTravel = millimeters(keys.number("stop_travel_mm", {0.1, 35.0}, 16.5));
  parameters.withdraws = keys.flag("withdraw", false);
  // The published text gives no speed; pulled by hand, so of the order of hand speeds.
  parameters.styletSpeed = millimetersPerSecond(keys.number("stylet_pull_mm_s", {0.1, 50.0}, 5.0));
  // Straight stretch before the spiral: 0 to 2 mm fit the published forces; longer ones are
  // drilled.
  parameters.cochlea.leadIn = millimeters(keys.number("lead_in_mm", {0.0, 5.0}, 1.0));
  // Beyond this the array meets the edge of the opening first.
  constexpr Range approach_deg{-anatomy::steepestApproach_deg, anatomy::steepestApproach_deg};
  parameters.approachTilt = degrees(keys.number("approach_tilt_deg", approach_deg, 0.0));
  parameters.approachTurn = degrees(keys.number("approach_turn_deg", approach_deg, 0.0));
}

/// The roof: Teflon in the published experiment, a membrane in a cochlea.
void readMembrane(ScenarioKeys& keys, const TomlReader& reader, InsertionParameters& parameters)
{
  parameters.membraneKind = keys.choice("membrane", membranes, parameters.membraneKind);
  // Point stiffnesses of 0.6 to 9 N/m are reported.
  mechanics::MembraneLaw law;
  law.perSamplePoint =
      newtonsPerMeter(keys.number("membrane_stiffness_N_m", {0.1, 100.0}, law.perSamplePoint.si()));
  if (parameters.membraneKind == MembraneKind::soft) parameters.membrane = law;
  // Rupture is reported at 0.042 to 0.122 N (Schuster et al. 2015); without the key there is none.
  if (reader.has("partition_strength_N"))
    parameters.partitionStrength = newtons(keys.number("partition_strength_N", {0.0, 2.0}, 0.0));
}

void readCoupling(ScenarioKeys& keys, InsertionParameters& parameters)
{
  haptics::EngineSettings& engine = parameters.engine;
  engine.coupling = keys.choice("coupling", couplings, engine.coupling);
  // Devices stay stable up to a few hundred N/m; a virtual hand may be stiffer.
  engine.couplingStiffness = keys.number("coupling_stiffness_N_m", {1.0, 10'000.0}, 441.0);
  engine.couplingDamping = keys.number("coupling_damping_N_s_m", {0.0, 100.0}, 1.0);
  // A consumer device's own friction (0.26 N) is above the forces here (0.1 N): up to 20 times
  // shown.
  engine.forceScale = keys.number("force_scale", {0.0, 20.0}, 1.0);
  engine.stopTravel = parameters.stopTravel.si();
  // Above 2 N the array is jammed.
  engine.stopForce = keys.number("stop_force_N", {0.0, haptics::maxHandForce}, 0.0);
  engine.styletSpeed = parameters.styletSpeed.si();
  engine.samplePeriod = parameters.timeStep.si();
}

Result<void> readArray(const std::string& name, ScenarioContent& scenario)
{
  const auto file = findByName("array", "plugins/electrodes", name);
  if (!file) return file.error();
  const auto content = readWhole(*file);
  if (!content) return content.error();
  auto array = electrode::loadArray(*file);
  if (!array) return array.error();
  scenario.parameters.array = *array;

  Hash hash;
  hash.addBytes(content->data(), content->size());
  scenario.arrayFingerprint = hexadecimal(hash.value());
  return {};
}

/// Notes where a key changes nothing of an array of the user's. Shipped ones keep what their file states by design.
void noteWhatFileKeeps(bool hasPacking, bool hasTaper, ScenarioContent& scenario)
{
  const electrode::ArrayDesign& array = scenario.parameters.array;
  const bool keepsStiffness =
      hasPacking && !array.hasStylet && !array.yields() && !electrode::wirePacking(array);
  const bool keepsWidths = hasTaper && !array.taper;
  if (!keepsStiffness && !keepsWidths) return;  // most scenarios, whose folder is not listed then
  const std::vector<std::string> shipped = shippedNames("plugins/electrodes");
  if (std::find(shipped.begin(), shipped.end(), scenario.arrayName) != shipped.end()) return;
  if (keepsStiffness)
    scenario.notes.push_back("The array " + array.name +
                             " has the stiffness of its file: wire_packing changes that of arrays "
                             "that state their wires and follow them.");
  if (keepsWidths)
    scenario.notes.push_back("The array " + array.name +
                             " has the widths of its file: taper_fraction changes those of arrays "
                             "that state a range of their taper.");
}

Result<ScenarioContent> readScenario(TomlReader& reader, const std::string& name,
                                     const fs::path& folder, const Overrides& overrides)
{
  dropNodesOfOtherModel(reader, overrides);
  dropFitOfOtherArray(reader, overrides);
  const auto overrideNamed = [&](const char* key) { return overrideOf(overrides, key); };
  dropWallOfOtherCochlea(reader, overrideNamed);
  dropPassageOfOtherOpening(reader, overrideNamed);
  bool namesPatient = false;
  for (const auto& [key, value] : overrides) {
    namesPatient = namesPatient || key == "patient";
    std::error_code ignored;
    const bool isFile = key == "patient" && fs::is_regular_file(value, ignored);
    reader.set(key, isFile ? fs::absolute(value).string() : value);
  }

  for (const char* key : fileKeys)
    if (reader.has(key) && overrideNamed(key) == nullptr) {
      const std::string given = reader.text(key);
      if (const std::string beside = pathBeside(given, folder); beside != given)
        reader.set(key, beside);
    }

  ScenarioContent scenario;
  InsertionParameters& parameters = scenario.parameters;
  parameters.name = fs::path(name).stem().string();
  ScenarioKeys keys(reader);
  scenario.title = keys.text("title", "");
  scenario.patientName = reader.text("patient", "");
  const auto read =
      readCochlea(reader, keys, scenario.patientName, folder, namesPatient, parameters.cochlea);
  readModel(keys, parameters);
  parameters.timeStep = milliseconds(keys.number("dt_ms", {0.1, 10.0}, 1.0));
  parameters.seed = keys.integer("seed", 0, std::numeric_limits<long>::max(), 1);
  readMotion(keys, parameters);
  // Forceps take the array 3 to 5 mm in front of the opening (choice, low); a machine's clamp, which
  // no key describes, holds its end.
  if (reader.has("free_length_mm"))
    parameters.freeLength = millimeters(keys.number("free_length_mm", {1.0, 60.0}, 4.0));
  const auto isOverridden = [&overrides](const std::string& key) {
    return std::any_of(overrides.begin(), overrides.end(),
                       [&key](const auto& entry) { return entry.first == key; });
  };
  readFriction(reader, keys, isOverridden, parameters.friction, parameters.frictionSpread);
  readRelaxation(reader, keys, parameters, parameters.relaxation);
  readOpening(keys, reader, parameters);
  readMembrane(keys, reader, parameters);
  readWall(keys, reader, scenario.patientName, parameters, parameters.wall);
  readCoupling(keys, parameters);

  keys.text("patient", "");
  anatomy::Patient& patient = parameters.cochlea.patient;
  patient.side = keys.choice("side", anatomy::sides, patient.side);
  scenario.arrayName = keys.text("array", "contour");
  scenario.expectedArrayFingerprint = reader.text("array_fingerprint", "");
  const auto calibration = readCalibration(reader, keys, scenario);
  const AskedYield yield = readYield(reader, keys, parameters.model);
  // What array files leave open. Wires that slide freely have 0, wires that are one solid rod 1.2; the
  // taper is the thinnest at 0 and the thickest at 1 (guide, method.md).
  std::optional<double> packing, taper;
  if (reader.has("wire_packing")) packing = keys.number("wire_packing", {0.0, 2.0}, 0.0);
  if (reader.has("taper_fraction")) taper = keys.number("taper_fraction", {0.0, 1.0}, 0.0);

  // What the file says itself comes before what the files it names say.
  if (const auto done = reader.finish(); !done) return done.error();
  if (!read) return read.error();
  if (const auto done = checkPassage(reader.name(), parameters); !done) return done.error();
  if (const auto done = anatomy::checkPatient(patient); !done) return done.error();
  if (const auto done = readArray(scenario.arrayName, scenario); !done) return done.error();
  if (!scenario.expectedArrayFingerprint.empty() &&
      scenario.expectedArrayFingerprint != scenario.arrayFingerprint)
    scenario.notes.push_back("The file of the array " + parameters.array.name +
                             " was changed since this scenario was written with it.");
  if (!calibration) return calibration.error();
  if (const auto done = applyYield(yield, reader.name(), scenario); !done) return done.error();
  if (packing) parameters.array = electrode::withWirePacking(std::move(parameters.array), *packing);
  if (taper) parameters.array = electrode::withTaper(std::move(parameters.array), *taper);
  noteWhatFileKeeps(packing.has_value(), taper.has_value(), scenario);
  if (const auto done = applyCalibration(*calibration, scenario); !done) return done.error();

  if (parameters.technique == Technique::advanceOffStylet) {
    if (!parameters.array.hasStylet || !parameters.array.stylet.holdDepth)
      return Error{"%1: technique is '%2', but the array %3 %4. Set technique to 'standard'.",
                   reader.name(), nameOf(parameters.technique), parameters.array.name,
                   parameters.array.hasStylet
                       ? Sentence{"names no depth at which its stylet is held"}
                       : Sentence{"has no stylet"}};
    parameters.engine.styletHoldDepth = parameters.array.stylet.holdDepth->si();
  }

  const Length deepest = parameters.startInside + parameters.stopTravel;
  // 2.0 mm + 16.5 mm is a rounding above 18.5 mm.
  const Length rounding = Length::fromSi(1e-9);
  if (deepest > parameters.array.insertable + rounding)
    return Error{
        "%1: start_inside_mm + stop_travel_mm is %2; the array %3 may go in %4 mm at most. Lower "
        "stop_travel_mm.",
        reader.name(), shortLength_mm(deepest), parameters.array.name,
        shortLength_mm(parameters.array.insertable)};

  if (const auto note = seatNote(parameters, deepest)) scenario.notes.push_back(*note);
  scenario.files = filesOf(scenario, reader.text("friction", "paper"), folder);

  keys.note("array_fingerprint", tomlQuoted(scenario.arrayFingerprint));
  keys.notePatient(patient, parameters.cochlea.source);
  scenario.values = keys.values();
  scenario.text = keys.asToml();
  return scenario;
}

/// The point set is a published model, which was validated as it was printed: an array that enters
/// straight, the printed wall and friction, and a device with the printed spring. A recording of
/// other numbers is read and replayed all the same.
Result<void> checkPublishedPoints(const InsertionParameters& parameters, const std::string& name)
{
  if (parameters.model != mechanics::ModelKind::points) return {};
  const mechanics::WallLaw wall;
  const mechanics::FrictionLaw friction;
  const haptics::EngineSettings& engine = parameters.engine;
  const bool isSpring = engine.coupling == mechanics::Coupling::spring;
  const double step_ms = inMilliseconds(parameters.timeStep);
  // On a spring the published loop of 1 kHz is stable, a slower one is not.
  const bool isSlow = isSpring && step_ms > 1.0 + 1e-9;
  struct Printed {
    const char* key;
    double is, printed;
  };
  const Printed all[] = {
      {"approach_tilt_deg", inDegrees(parameters.approachTilt), 0.0},
      {"approach_turn_deg", inDegrees(parameters.approachTurn), 0.0},
      {"wall_stiffness_N_m", parameters.wall.perSamplePoint.si(), wall.perSamplePoint.si()},
      {"wall_tangential_stiffness_N_m", parameters.wall.tangentialPerSamplePoint.si(),
       wall.tangentialPerSamplePoint.si()},
      {"friction_static", parameters.friction.staticCoefficient, friction.staticCoefficient},
      {"friction_dynamic", parameters.friction.kineticCoefficient, friction.kineticCoefficient},
      {"friction_stopping", parameters.friction.stoppingCoefficient, friction.stoppingCoefficient},
      {"dt_ms", isSlow ? step_ms : 1.0, 1.0},
      {"coupling_stiffness_N_m", isSpring ? engine.couplingStiffness : 441.0, 441.0},
      {"coupling_damping_N_s_m", isSpring ? engine.couplingDamping : 1.0, 1.0}};
  for (const Printed& each : all)
    if (each.is != each.printed)
      return Error{
          "%1: %2 is %3, and the published model of points has %4 only. Set model to 'rod', or %2 "
          "to %5.",
          name,
          each.key,
          shortestDecimal(each.is),
          shortestDecimal(each.printed),
          shortestDecimal(each.printed)};
  return {};
}

}  // namespace

Result<Scenario> loadScenario(const std::string& nameOrFile, const Overrides& overrides)
{
  const auto file = findByName("scenario", "resources/scenarios", nameOrFile);
  if (!file) return file.error();
  auto reader = TomlReader::open(*file);
  if (!reader) return reader.error();
  auto content = readScenario(*reader, file->string(), file->parent_path(), overrides);
  if (!content) return content.error();
  if (const auto done = checkPublishedPoints(content->parameters, file->string()); !done)
    return done.error();
  content->files.push_back(*file);
  return Scenario(*std::move(content));
}

Result<Scenario> parseScenario(const std::string& text, const std::string& name,
                               const Overrides& overrides)
{
  auto reader = TomlReader::parse(text, name);
  if (!reader) return reader.error();
  auto content = readScenario(*reader, name, {}, overrides);
  if (!content) return content.error();
  return Scenario(*std::move(content));
}

Scenario::Scenario() : content_(std::make_shared<const ScenarioContent>()) {}

Scenario::Scenario(ScenarioContent content)
    : content_(std::make_shared<const ScenarioContent>(std::move(content)))
{
}

Scenario::~Scenario() = default;
Scenario::Scenario(const Scenario&) = default;
Scenario& Scenario::operator=(const Scenario&) = default;

Result<Scenario> Scenario::with(const Overrides& overrides) const
{
  Overrides all = overrides;
  // what the text was read with still holds, but for another array
  const bool keepsArray = overrideOf(overrides, "array") == nullptr;
  all.insert(all.begin(), {"array_fingerprint",
                           tomlQuoted(keepsArray ? expectedArrayFingerprint() : std::string())});
  // a name with a point would lose what follows it
  auto changed = parseScenario(text(), name() + ".toml", all);
  if (!changed) return changed;
  if (keepsArray && changed->arrayFingerprint() != arrayFingerprint())
    return Error{
        "The file of the array %1 was changed since the scenario %2 was read. Read the scenario "
        "again.",
        array().name, name()};
  ScenarioContent content = *changed->content_;
  if (const auto done = checkPublishedPoints(content.parameters, name()); !done)
    return done.error();
  for (const fs::path& file : files())
    if (std::find(content.files.begin(), content.files.end(), file) == content.files.end())
      content.files.push_back(file);
  return Scenario(std::move(content));
}

}  // namespace perilymph::session
