// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Scenario.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"
#include "scenario/EffectiveText.h"
#include "scenario/ScenarioCalibration.h"
#include "scenario/ScenarioFiles.h"
#include "scenario/ScenarioFriction.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

std::string hexadecimal(std::uint64_t value)
{
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value));
  return digits;
}

/// Millimeters for a message: 27, 18.5.
std::string shortLength_mm(Length length)
{
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", inMillimeters(length));
  return digits;
}

// The published number of sample points (Todd and Naghdy, section II.C).
constexpr int publishedPoints = 12;

/// "one, two, three"
std::string joined(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The last override of a key; null if there is none.
const std::string* overrideOf(const Overrides& overrides, const char* key)
{
  const auto is = [key](const auto& entry) { return entry.first == key; };
  const auto last = std::find_if(overrides.rbegin(), overrides.rend(), is);
  return last == overrides.rend() ? nullptr : &last->second;
}

/// A new array does not inherit the calibration that a file specifies for another one.
void forgetCalibrationOfOtherArray(TomlReader& reader, const Overrides& overrides)
{
  const std::string* array = overrideOf(overrides, "array");
  if (array == nullptr || *array == reader.text("array", "contour")) return;
  // the text of a recording also contains the numbers themselves
  for (const char* key : {"calibration", "stiffness_scale", "residual_curvature_fraction"})
    if (overrideOf(overrides, key) == nullptr) reader.remove(key);
}

/// A new model does not inherit the number of nodes that a file specifies for another one.
void forgetNodesOfOtherModel(TomlReader& reader, const Overrides& overrides)
{
  const std::string* model = overrideOf(overrides, "model");
  if (model == nullptr || overrideOf(overrides, "nodes") != nullptr || !reader.has("nodes")) return;
  if (*model == reader.text("model", "rod")) return;
  reader.set("nodes", std::to_string(*model == "points" ? publishedPoints : Scenario{}.nodes));
}

void readModel(TomlReader& reader, ScenarioKeys& keys, Scenario& scenario)
{
  const std::string model = keys.text("model", "rod");
  if (model != "rod" && model != "points")
    reader.refuse("model", "model is '" + model + "'; it must be 'rod' or 'points'.");
  if (model == "points") {
    scenario.model = mechanics::ModelKind::points;
    // Two points define a line; with more than eighteen the published model oscillates at 1 kHz.
    scenario.nodes =
        static_cast<int>(keys.integer("nodes", 2, mechanics::maxPoints, publishedPoints));
    return;
  }
  // More than 1024 nodes do not fit into a snapshot; fewer than 8 cannot follow the spiral.
  scenario.nodes = static_cast<int>(keys.integer("nodes", 8, mechanics::maxNodes, 100));
}

void readMotion(TomlReader& reader, ScenarioKeys& keys, Scenario& scenario)
{
  scenario.technique = keys.text("technique", "standard");
  if (scenario.technique != "standard" && scenario.technique != "aos")
    reader.refuse("technique", "technique is '" + scenario.technique +
                                   "'; it must be 'standard' or 'aos' (advance off stylet).");
  // Robots move at 0.1 to 1 mm/s, hands at 0.9, the published test rig at 2 (Todd and Naghdy,
  // section II.A; Kesler 2017); a slip of the hand reaches 200.
  scenario.speed = millimetersPerSecond(keys.number("speed_mm_s", {0.01, 200.0}, 2.0));
  // The published test rig starts 1 to 3 mm inside; a free hand 5 mm before the opening.
  scenario.startInside = millimeters(keys.number("start_inside_mm", {-10.0, 10.0}, 2.0));
  // No array is longer than 31.5 mm (MED-EL Standard).
  scenario.stopTravel = millimeters(keys.number("stop_travel_mm", {0.1, 35.0}, 16.5));
  scenario.withdraws = keys.flag("withdraw", false);
  // The publication gives no speed; the stylet is pulled by hand, so of the order of hand speeds.
  scenario.styletSpeed = millimetersPerSecond(keys.number("stylet_pull_mm_s", {0.1, 50.0}, 5.0));
  // Straight section before the spiral: 0 to 2 mm fit the published forces; longer ones are
  // drilled.
  scenario.leadIn = millimeters(keys.number("lead_in_mm", {0.0, 5.0}, 1.0));
  // Beyond this the array hits the edge of the opening first.
  scenario.approachTilt = degrees(keys.number("approach_tilt_deg", {-30.0, 30.0}, 0.0));
  scenario.approachTurn = degrees(keys.number("approach_turn_deg", {-30.0, 30.0}, 0.0));
}

/// Reads the roof: Teflon in the published experiment, a membrane in a cochlea.
void readMembrane(TomlReader& reader, ScenarioKeys& keys, Scenario& scenario)
{
  scenario.membraneName = keys.text("membrane", "rigid");
  if (scenario.membraneName != "rigid" && scenario.membraneName != "soft")
    reader.refuse("membrane",
                  "membrane is '" + scenario.membraneName + "'; it must be 'rigid' or 'soft'.");
  // Reported point stiffnesses are 0.6 to 9 N/m.
  mechanics::MembraneLaw law;
  law.perSamplePoint =
      newtonsPerMeter(keys.number("membrane_stiffness_N_m", {0.1, 100.0}, law.perSamplePoint.si()));
  if (scenario.membraneName == "soft") scenario.membrane = law;
}

/// Reads the rim of the opening, which the array passes and its ribs touch.
void readOpening(TomlReader& reader, ScenarioKeys& keys, Scenario& scenario)
{
  scenario.openingName = keys.text("opening", "none");
  // Drilled openings are 0.8 to 1.5 mm wide; the published one passed a carrier of 0.8 mm.
  const double diameter = keys.number("cochleostomy_diameter_mm", {0.5, 3.0}, 1.0);
  if (scenario.openingName == "round-window") scenario.opening = mechanics::roundWindow();
  if (scenario.openingName == "cochleostomy")
    scenario.opening = mechanics::cochleostomy(millimeters(diameter));
  if (!scenario.opening && scenario.openingName != "none")
    reader.refuse("opening", "opening is '" + scenario.openingName +
                                 "'; it must be one of none, round-window, cochleostomy.");
}

void readWallAndCoupling(TomlReader& reader, ScenarioKeys& keys, Scenario& scenario)
{
  // 441 and 200 N/m are those of the published simulator, under each of its sample points (Todd and
  // Naghdy, section II.D); bone has about 2,000 to 10,000, where the solver is still stable.
  scenario.wall.perSamplePoint =
      newtonsPerMeter(keys.number("wall_stiffness_N_m", {10.0, 10'000.0}, 441.0));
  scenario.wall.tangentialPerSamplePoint =
      newtonsPerMeter(keys.number("wall_tangential_stiffness_N_m", {10.0, 10'000.0}, 200.0));

  haptics::EngineSettings& engine = scenario.engine;
  const std::string coupling = keys.text("coupling", "rigid");
  engine.coupling = coupling == "spring" ? mechanics::Coupling::spring : mechanics::Coupling::rigid;
  if (coupling != "rigid" && coupling != "spring")
    reader.refuse("coupling", "coupling is '" + coupling + "'; it must be 'rigid' or 'spring'.");
  // Devices stay stable up to a few hundred N/m; a virtual hand may be stiffer.
  engine.couplingStiffness = keys.number("coupling_stiffness_N_m", {1.0, 10'000.0}, 441.0);
  engine.couplingDamping = keys.number("coupling_damping_N_s_m", {0.0, 100.0}, 1.0);
  // A consumer device's own friction (0.26 N) exceeds the forces here (0.1 N): scale by up to 20.
  engine.forceScale = keys.number("force_scale", {0.0, 20.0}, 1.0);
  engine.stopTravel = scenario.stopTravel.si();
  engine.styletSpeed = scenario.styletSpeed.si();
  engine.samplePeriod = scenario.timeStep.si();
}

/// The patient in an effective text: three lengths, or A, B and optionally H, or only a label if
/// the anatomy needs no numbers.
anatomy::Patient patientFromNumbers(TomlReader numbers)
{
  anatomy::Patient patient;
  patient.label = numbers.text("label", patient.label);
  if (numbers.has("a_mm")) {
    // the population's limits are checked later, for the whole patient
    const auto diameter = [&numbers](const char* key) {
      return millimeters(numbers.number(key, {0.0, 20.0}));
    };
    anatomy::BasalTurn turn{diameter("a_mm"), diameter("b_mm"), std::nullopt};
    if (numbers.has("h_mm")) turn.h = diameter("h_mm");
    patient.basalTurn = turn;
    return patient;
  }
  if (!numbers.has("st_length_mm")) return patient;
  const anatomy::PatientLimits limits = anatomy::patientLimits();
  const auto length = [&numbers](const char* key, Length low, Length high) {
    return millimeters(numbers.number(key, {inMillimeters(low), inMillimeters(high)}));
  };
  patient.scalaTympaniLength = length("st_length_mm", limits.lengthLow, limits.lengthHigh);
  patient.roundWindowWidth = length("rw_width_mm", limits.widthLow, limits.widthHigh);
  patient.roundWindowHeight = length("rw_height_mm", limits.heightLow, limits.heightHigh);
  return patient;
}

/// @param isNamedAnew  The patient came as an override, so numbers in the text are ignored.
Result<anatomy::Patient> readPatient(TomlReader& reader, const std::string& name,
                                     const fs::path& folder, bool isNamedAnew)
{
  anatomy::Patient patient;
  const bool hasNumbers = reader.has("patient_numbers");
  if (hasNumbers) patient = patientFromNumbers(reader.table("patient_numbers"));
  if (name.empty() || (hasNumbers && !isNamedAnew)) return patient;
  const auto file = findPatient(name, folder);
  if (!file) return file.error();
  return anatomy::loadPatient(*file);
}

/// Reads the anatomy; by default the one that the patient's numbers define, or the mean one without
/// a patient.
void readAnatomy(TomlReader& reader, ScenarioKeys& keys, const anatomy::Patient& patient,
                 bool hasPatient, anatomy::AnatomySource& anatomy)
{
  using anatomy::PatientMeasures;
  const PatientMeasures given =
      hasPatient || patient.basalTurn ? measuresOf(patient) : PatientMeasures::none;
  const anatomy::AnatomySource usual =
      given == PatientMeasures::none ? anatomy::defaultAnatomy : sourceScaledBy(given);
  const std::string name = keys.text("anatomy", nameOf(usual));
  const auto named = anatomy::anatomySourceNamed(name);
  if (!named)
    return reader.refuse("anatomy", "anatomy is '" + name + "'; it must be one of " +
                                        joined(anatomy::anatomySourceNames()) + ".");
  anatomy = *named;
  const anatomy::AnatomySourceTraits& traits = traitsOf(anatomy);
  const std::string head = "anatomy is '" + name + "', ";
  if (traits.takes == PatientMeasures::none) {
    if (hasPatient)
      reader.refuse("anatomy", head +
                                   "which is not built from a patient's numbers; leave 'patient' "
                                   "out.");
    return;
  }
  if (given == PatientMeasures::none || given == traits.takes) return;
  const std::string other = nameOf(sourceScaledBy(given));
  reader.refuse("anatomy", head + "but the patient '" + patient.label + "' gives " + keysOf(given) +
                               ", from which the " + other + " anatomy is built; " +
                               (traits.alwaysTakes ? "set anatomy to '" + other + "'."
                                                   : std::string("name a patient with ") +
                                                         keysOf(traits.takes) + ", or none."));
}

void readSide(TomlReader& reader, ScenarioKeys& keys, anatomy::Patient& patient)
{
  const char* usual = patient.side == anatomy::Side::left ? "left" : "right";
  const std::string side = keys.text("side", usual);
  if (side != "left" && side != "right")
    reader.refuse("side", "side is '" + side + "'; it must be 'right' or 'left'.");
  patient.side = side == "left" ? anatomy::Side::left : anatomy::Side::right;
}

Result<Done> readArray(const std::string& name, Scenario& scenario)
{
  const auto file = findByName("array", "plugins/electrodes", name);
  if (!file) return file.error();
  const auto content = readWhole(*file);
  if (!content) return content.error();
  auto array = electrode::loadArray(*file);
  if (!array) return array.error();
  scenario.array = *array;

  Hash hash;
  hash.addBytes(content->data(), content->size());
  scenario.arrayFingerprint = hexadecimal(hash.value());
  return Done{};
}

/// Adds a note if the insertion is deeper than the array fits through the opening.
void noteSeat(Scenario& scenario, Length deepest)
{
  if (!scenario.opening) return;
  const Length narrow = std::min(scenario.opening->width, scenario.opening->height);
  const Length wide = std::max(scenario.opening->width, scenario.opening->height);
  const Length step = millimeters(0.05);
  for (Length place = millimeters(0); place < deepest; place = place + step) {
    const electrode::Section section = scenario.array.sectionAt(place);
    const Length across = std::max(section.across, section.within);
    if (across <= wide && std::min(section.across, section.within) <= narrow) continue;
    scenario.notes.push_back("The array " + scenario.array.name + " is " + shortLength_mm(across) +
                             " mm thick " + shortLength_mm(place) +
                             " mm behind its tip, the opening " + shortLength_mm(narrow) +
                             " mm wide: it comes to rest there and can only be forced deeper.");
    return;
  }
}

Result<Scenario> readScenario(TomlReader& reader, const std::string& name, const fs::path& folder,
                              const Overrides& overrides)
{
  forgetNodesOfOtherModel(reader, overrides);
  forgetCalibrationOfOtherArray(reader, overrides);
  bool namesPatient = false;
  for (const auto& [key, value] : overrides) {
    namesPatient = namesPatient || key == "patient";
    std::error_code ignored;
    const bool isFile = key == "patient" && fs::is_regular_file(value, ignored);
    reader.set(key, isFile ? fs::absolute(value).string() : value);
  }

  Scenario scenario;
  scenario.name = fs::path(name).stem().string();
  ScenarioKeys keys(reader);
  scenario.title = keys.text("title", "");
  scenario.patientName = reader.text("patient", "");
  auto patient = readPatient(reader, scenario.patientName, folder, namesPatient);
  if (patient) {
    scenario.patient = *patient;
    const bool hasPatient =
        !scenario.patientName.empty() || reader.table("patient_numbers").has("st_length_mm");
    readAnatomy(reader, keys, *patient, hasPatient, scenario.anatomy);
  } else {
    reader.text("anatomy", "");  // a known key; without its patient there is nothing to compare
  }
  readModel(reader, keys, scenario);
  // Forces change by less than 0.4 mN over this range of time steps.
  scenario.timeStep = milliseconds(keys.number("dt_ms", {0.1, 10.0}, 1.0));
  scenario.seed = keys.integer("seed", 0, std::numeric_limits<long>::max(), 1);
  readMotion(reader, keys, scenario);
  const auto isOverridden = [&overrides](const std::string& key) {
    return std::any_of(overrides.begin(), overrides.end(),
                       [&key](const auto& entry) { return entry.first == key; });
  };
  readFriction(reader, keys, isOverridden, scenario.friction);
  readOpening(reader, keys, scenario);
  readMembrane(reader, keys, scenario);
  readWallAndCoupling(reader, keys, scenario);

  keys.text("patient", "");
  readSide(reader, keys, scenario.patient);
  scenario.arrayName = keys.text("array", "contour");
  scenario.expectedArrayFingerprint = reader.text("array_fingerprint", "");
  const auto calibration = readCalibration(reader, keys, scenario);

  // Report errors of the file itself before those of the files it names.
  if (const auto done = reader.finish(); !done) return done.error();
  if (!patient) return patient.error();
  if (const auto done = anatomy::checkPatient(scenario.patient); !done) return done.error();
  if (const auto done = readArray(scenario.arrayName, scenario); !done) return done.error();
  if (!calibration) return calibration.error();
  if (const auto done = applyCalibration(*calibration, scenario); !done) return done.error();

  if (scenario.technique == "aos") {
    if (!scenario.array.hasStylet || !scenario.array.stylet.holdDepth)
      return Error{reader.name() + ": technique is 'aos', but the array " + scenario.array.name +
                   (scenario.array.hasStylet ? " names no depth at which its stylet is held."
                                             : " has no stylet.") +
                   " Set technique to 'standard'."};
    scenario.engine.styletHoldDepth = scenario.array.stylet.holdDepth->si();
  }

  const Length deepest = scenario.startInside + scenario.stopTravel;
  // Because of rounding, 2.0 mm + 16.5 mm exceeds 18.5 mm.
  const Length rounding = Length::fromSi(1e-9);
  if (deepest > scenario.array.insertable + rounding)
    return Error{reader.name() + ": start_inside_mm + stop_travel_mm is " +
                 shortLength_mm(deepest) + "; the array " + scenario.array.name + " may go in " +
                 shortLength_mm(scenario.array.insertable) + " mm at most. Lower stop_travel_mm."};

  noteSeat(scenario, deepest);
  scenario.files = filesOf(scenario, reader.text("friction", "paper"), folder);

  keys.note("array_fingerprint", tomlText(scenario.arrayFingerprint));
  keys.notePatient(scenario.patient, scenario.anatomy);
  scenario.values = keys.values();
  scenario.text = keys.asToml();
  return scenario;
}

}  // namespace

Result<Scenario> loadScenario(const std::string& nameOrFile, const Overrides& overrides)
{
  const auto file = findByName("scenario", "resources/scenarios", nameOrFile);
  if (!file) return file.error();
  auto reader = TomlReader::open(*file);
  if (!reader) return reader.error();
  auto scenario = readScenario(*reader, file->string(), file->parent_path(), overrides);
  if (scenario) scenario->files.push_back(*file);
  return scenario;
}

Result<Scenario> parseScenario(const std::string& text, const std::string& name,
                               const Overrides& overrides)
{
  auto reader = TomlReader::parse(text, name);
  if (!reader) return reader.error();
  return readScenario(*reader, name, {}, overrides);
}

}  // namespace perilymph::session
