// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/Setup.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <utility>

#include "gui/run/ScenarioDifference.h"
#include "gui/setup/StopTravel.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlQuoted.h"

namespace perilymph::gui {

namespace {

using Values = session::Overrides;

constexpr auto numbers = "patient_numbers.";
constexpr auto label = "patient_numbers.label";

bool startsWith(const std::string& key, const std::string& head)
{
  return key.compare(0, head.size(), head) == 0;
}

void drop(Values& values, const std::function<bool(const std::string&)>& isMeant)
{
  values.erase(std::remove_if(values.begin(), values.end(),
                              [&](const auto& entry) { return isMeant(entry.first); }),
               values.end());
}

void set(Values& values, const std::string& key, const std::string& value)
{
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const auto& entry) { return entry.first == key; });
  if (found == values.end())
    values.emplace_back(key, value);
  else
    found->second = value;
}

std::string valueOf(const Values& values, const std::string& key)
{
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const auto& entry) { return entry.first == key; });
  return found == values.end() ? std::string() : found->second;
}

/// Copies the values of some keys from another scenario; keys missing there are removed.
void takeOver(Values& values, const Values& from,
              const std::function<bool(const std::string&)>& isMeant)
{
  drop(values, isMeant);
  for (const auto& entry : from)
    if (isMeant(entry.first)) values.push_back(entry);
}

bool isCalibration(const std::string& key)
{
  return key == "calibration" || key == "stiffness_scale" || key == "residual_curvature_fraction";
}

bool isFrictionNumber(const std::string& key) { return startsWith(key, "friction_"); }

bool isPatientNumber(const std::string& key) { return startsWith(key, numbers) && key != label; }

bool isMeasuringError(const std::string& key)
{
  return isPatientNumber(key) && key.ends_with("_sd_mm");
}

/// The order of keys is irrelevant: sort them for comparison.
Values sorted(Values values)
{
  std::sort(values.begin(), values.end());
  return values;
}

Values only(Values values, const std::function<bool(const std::string&)>& isMeant)
{
  drop(values, [&](const std::string& key) { return !isMeant(key); });
  return sorted(std::move(values));
}

std::string millimetersText(Length length)
{
  QString text = QString::number(inMillimeters(length), 'g', 9);
  if (!text.contains(QLatin1Char('.'))) text += QStringLiteral(".0");
  return text.toStdString();
}

Result<void> followArray(Values& values, const Setup& now, const SetupOrigin& origin)
{
  const session::Scenario& first = origin.setup.scenario;
  drop(values, [](const std::string& key) { return key == "array_fingerprint"; });
  const std::string quoted = valueOf(values, "array");
  const std::string name = quoted.size() > 1 ? quoted.substr(1, quoted.size() - 2) : quoted;
  if (name == first.arrayName()) {
    takeOver(values, first.values(), isCalibration);
  } else {
    drop(values, isCalibration);
    set(values, "calibration", "\"\"");
  }
  const auto file = findByName("array", "plugins/electrodes", name);
  if (!file) return file.error();
  const auto array = electrode::loadArray(*file);
  if (!array) return array.error();
  if (!array->hasStylet || !array->stylet.holdDepth)
    set(values, "technique", tomlQuoted(QLatin1String(nameOf(session::Technique::standard))));

  // The preset's stop travel belongs to its array; any other array is inserted fully. A chosen stop
  // travel is only reduced.
  const Length startInside = now.scenario.startInside();
  const auto usualOf = [&](const electrode::ArrayDesign& design, const std::string& named) {
    return named == first.arrayName() ? first.stopTravel() : deepestStop(design, startInside);
  };
  const bool isChosen =
      now.scenario.stopTravel() != usualOf(now.scenario.array(), now.scenario.arrayName());
  const Length stop = isChosen
                          ? std::min(now.scenario.stopTravel(), deepestStop(*array, startInside))
                          : usualOf(*array, name);
  if (stop == first.stopTravel())
    takeOver(values, first.values(),
             [](const std::string& key) { return key == "stop_travel_mm"; });
  else
    set(values, "stop_travel_mm", millimetersText(stop));
  return {};
}

Result<void> follow(Values& values, const Setup& now, const SetupOrigin& origin, SetupField field)
{
  const Values& first = origin.setup.scenario.values();
  switch (field) {
    case SetupField::array:
      return followArray(values, now, origin);
    case SetupField::stopTravel: {
      const Length deepest = deepestStop(now.scenario.array(), now.scenario.startInside());
      const double asked_mm = std::strtod(valueOf(values, "stop_travel_mm").c_str(), nullptr);
      const double beyond_mm = asked_mm - inMillimeters(deepest);
      if (beyond_mm > 0.0 && beyond_mm < 0.01)
        set(values, "stop_travel_mm", millimetersText(deepest));
      break;
    }
    case SetupField::friction:
      drop(values, isFrictionNumber);
      if (valueOf(values, "friction") == valueOf(first, "friction"))
        takeOver(values, first, isFrictionNumber);
      break;
    case SetupField::model: {
      const auto isNodes = [](const std::string& key) { return key == "nodes"; };
      drop(values, isNodes);
      if (valueOf(values, "model") == valueOf(first, "model")) takeOver(values, first, isNodes);
      break;
    }
    default:
      break;
  }
  return {};
}

/// An entered measure has the assumed error and the others keep theirs; one that is the origin's again
/// has that one's error and source. Errors that are all assumed are not stated.
void followError(Values& values, const Setup& origin, SetupField field,
                 std::map<SetupField, ValueSource>& sources)
{
  constexpr std::array<std::pair<SetupField, const char*>, 3> measures{
      {{SetupField::lengthA, "a"}, {SetupField::widthB, "b"}, {SetupField::heightH, "h"}}};
  const auto named =
      std::ranges::find(measures, field, [](const auto& each) { return each.first; });
  if (named == measures.end()) return;
  const Values& first = origin.scenario.values();
  const auto keyOf = [](const char* measure, const char* end) {
    return std::string(numbers) + measure + end;
  };
  const auto lengthIn = [](const Values& among, const std::string& key) {
    return std::strtod(valueOf(among, key).c_str(), nullptr);
  };
  const std::string value = keyOf(named->second, "_mm"), error = keyOf(named->second, "_sd_mm");
  const bool isFirst = std::fabs(lengthIn(values, value) - lengthIn(first, value)) < 1e-9;
  const bool isStated = isFirst && !valueOf(first, error).empty();
  if (isFirst) sources[field] = origin.sourceOf(field);
  if (!isStated && valueOf(values, keyOf("a", "_sd_mm")).empty()) return;
  for (const char* each : {"a", "b"})
    if (const std::string key = keyOf(each, "_sd_mm"); valueOf(values, key).empty())
      set(values, key, millimetersText(analysis::measuringError));
  if (isStated)
    set(values, error, valueOf(first, error));
  else if (field == SetupField::heightH)
    drop(values, [&error](const std::string& key) { return key == error; });
  else
    set(values, error, millimetersText(analysis::measuringError));
  const auto isAssumed = [&](const char* measure) {
    const double stated = lengthIn(values, keyOf(measure, "_sd_mm"));
    return stated == 0.0 || std::fabs(stated - inMillimeters(analysis::measuringError)) < 1e-9;
  };
  if (isAssumed("a") && isAssumed("b") && isAssumed("h")) drop(values, isMeasuringError);
}

/// Modified numbers lose the patient's name; the origin's numbers have the origin's name.
void followPatient(Values& values, const SetupOrigin& origin, SetupField field)
{
  const Values& first = origin.setup.scenario.values();
  const bool isSame = only(values, isPatientNumber) == only(first, isPatientNumber);
  const std::string firstLabel = valueOf(first, label);
  if (isSame && valueOf(values, label) == "\"unnamed\"" && field != SetupField::patientLabel) {
    set(values, label, firstLabel);
    set(values, "patient", valueOf(first, "patient"));
  } else if (!isSame) {
    set(values, "patient", "\"\"");
    if (origin.kind == SetupOrigin::Kind::preset && valueOf(values, label) == firstLabel)
      set(values, label, "\"unnamed\"");
  }
}

Result<session::Scenario> read(const Values& values, const std::string& name)
{
  std::string text;
  for (const auto& [key, value] : values) text += key + " = " + value + '\n';
  return session::parseScenario(text, name);
}

std::string joined(const std::vector<std::string>& caption)
{
  std::string text;
  for (const std::string& word : caption) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::string tomlQuoted(const QString& text)
{
  QString printed;
  for (const QChar& each : text)
    if (each >= QLatin1Char(' ') && each != QChar(0x7F)) printed += each;
  return perilymph::tomlQuoted(printed.toStdString());
}

Result<Setup> changed(const Setup& now, const SetupOrigin& origin, const SetupChange& change)
{
  const session::Scenario& first = origin.setup.scenario;
  Values values = now.scenario.values();
  Setup made;
  made.sources = now.sources;
  if (change.field == SetupField::anatomy) {
    drop(values, isPatientNumber);
    made.sources.clear();
  }
  for (const auto& [key, value] : change.values) {
    // an empty value removes a number
    if (value.empty())
      drop(values, [named = key](const std::string& own) { return own == named; });
    else
      set(values, key, value);
  }
  const bool isMeasure =
      change.field >= SetupField::scalaLength && change.field <= SetupField::heightH;
  if (isMeasure) made.sources[change.field] = change.sources;
  if (isMeasure) followError(values, origin.setup, change.field, made.sources);
  if (const auto done = follow(values, now, origin, change.field); !done) return done.error();
  followPatient(values, origin, change.field);

  const bool isPreset = origin.kind == SetupOrigin::Kind::preset;
  const std::string file = first.name() + (isPreset ? "-modified.toml" : ".toml");
  auto plain = read(values, file);
  if (!plain) return plain.error();
  const std::vector<std::string> caption = differingText(first, *plain);
  if (caption.empty()) {
    made.scenario = first;
    made.sources = origin.setup.sources;
    return made;
  }
  if (isPreset) {
    const std::string claimed = first.title().empty() ? first.name() : first.title();
    set(values, "title",
        tomlQuoted(QString::fromStdString("Modified (" + joined(caption) + "): " + claimed)));
    auto titled = read(values, file);
    if (!titled) return titled.error();
    made.scenario = *std::move(titled);
    return made;
  }
  auto own = asOwn(*plain);
  if (!own) return own.error();
  made.scenario = *std::move(own);
  return made;
}

std::vector<std::string> differingText(const session::Scenario& one, const session::Scenario& other)
{
  const std::vector<std::string> keys = differingKeys(one, other);
  const auto differs = [&keys](const std::function<bool(const std::string&)>& isMeant) {
    return std::any_of(keys.begin(), keys.end(), isMeant);
  };
  const auto named = [](const char* name) {
    return [name](const std::string& key) { return key == name; };
  };
  const std::pair<Phrase, std::function<bool(const std::string&)>> groups[] = {
      {Phrase{"patient"}, [](const std::string& key) { return startsWith(key, "patient"); }},
      {Phrase{"ear"}, named("side")},
      {Phrase{"anatomy"}, named("anatomy")},
      {Phrase{"array"}, [](const std::string& key) { return startsWith(key, "array"); }},
      {Phrase{"calibration"}, isCalibration},
      {Phrase{"technique"}, named("technique")},
      {Phrase{"speed"}, named("speed_mm_s")},
      {Phrase{"full depth"}, named("stop_travel_mm")},
      {Phrase{"friction"}, [](const std::string& key) { return startsWith(key, "friction"); }},
      {Phrase{"opening"}, named("opening")},
      {Phrase{"approach"}, [](const std::string& key) { return startsWith(key, "approach_"); }},
      {Phrase{"model"}, named("model")},
      {Phrase{"nodes"}, named("nodes")},
      {Phrase{"force scale"}, named("force_scale")},
  };
  std::vector<std::string> caption;
  for (const auto& [word, isMeant] : groups)
    if (differs(isMeant)) caption.emplace_back(word.english());
  const auto isGrouped = [&groups](const std::string& key) {
    return std::any_of(std::begin(groups), std::end(groups),
                       [&key](const auto& group) { return group.second(key); });
  };
  for (const std::string& key : keys)
    if (!isGrouped(key)) caption.push_back(key);
  return caption;
}

std::string fileStemOf(const std::string& name)
{
  std::string file;
  for (const char c : name) {
    const bool isPlain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (isPlain)
      file += c;
    else if (!file.empty() && file.back() != '-')
      file += '-';
  }
  while (!file.empty() && file.back() == '-') file.pop_back();
  return file.empty() ? "patient" : file;
}

std::string fileNameOf(const std::string& name) { return fileStemOf(name) + ".toml"; }

Result<session::Scenario> withPatient(const session::Scenario& scenario,
                                      const anatomy::Patient& patient)
{
  Values values = scenario.values();
  drop(values, [](const std::string& key) { return startsWith(key, numbers); });
  const auto setNumber = [&values](const char* key, Length length) {
    set(values, std::string(numbers) + key, millimetersText(length));
  };
  const anatomy::PatientMeasures measures = measuresOf(patient);
  set(values, "anatomy", std::string("\"") + nameOf(sourceScaledBy(measures)) + '"');
  set(values, "side", tomlQuoted(QString::fromLatin1(anatomy::nameOf(patient.side))));
  set(values, "patient", "\"\"");
  set(values, label, tomlQuoted(QString::fromStdString(patient.label)));
  if (patient.seal == Seal::changed) set(values, std::string(numbers) + "changed_by_hand", "true");
  if (patient.basalTurn) {
    setNumber("a_mm", patient.basalTurn->a);
    setNumber("b_mm", patient.basalTurn->b);
    if (patient.basalTurn->h) setNumber("h_mm", *patient.basalTurn->h);
    if (const auto& errors = patient.errors) {
      setNumber("a_sd_mm", errors->a);
      setNumber("b_sd_mm", errors->b);
      if (errors->h) setNumber("h_sd_mm", *errors->h);
    }
  } else {
    setNumber("st_length_mm", patient.scalaTympaniLength);
    setNumber("rw_width_mm", patient.roundWindowWidth);
    setNumber("rw_height_mm", patient.roundWindowHeight);
  }
  const auto plain = read(values, fileNameOf(patient.label));
  if (!plain) return plain.error();
  return asOwn(*plain);
}

SetupChange approachChange(const anatomy::Approach& approach)
{
  const auto text = [](Angle angle) {
    const double rounded = 0.01 * std::round(100.0 * inDegrees(angle));
    const QString decimal = QString::number(rounded + 0.0, 'g', 6);  // never "-0"
    return (decimal.contains(QLatin1Char('.')) ? decimal : decimal + QStringLiteral(".0"))
        .toStdString();
  };
  return {SetupField::approach,
          {{"approach_tilt_deg", text(approach.tilt)}, {"approach_turn_deg", text(approach.turn)}},
          QCoreApplication::translate("perilymph::gui", "line of approach"),
          {}};
}

Result<session::Scenario> withApproach(const session::Scenario& scenario,
                                       const anatomy::Approach& approach)
{
  Values values = scenario.values();
  for (const auto& [key, value] : approachChange(approach).values) set(values, key, value);
  return read(values, scenario.name() + ".toml");
}

Result<session::Scenario> asOwn(const session::Scenario& scenario)
{
  Values values = scenario.values();
  set(values, "title",
      tomlQuoted(QString::fromStdString(scenario.patient().label + ": " + scenario.array().name)));
  return read(values, fileNameOf(scenario.patient().label));
}

}  // namespace perilymph::gui
