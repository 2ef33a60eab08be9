// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>

#include "Commands.h"
#include "DeviceReplay.h"
#include "DeviceTrial.h"
#include "JsonText.h"
#include "Terminal.h"
#include "perilymph/device/DeviceRegistry.h"
#include "perilymph/device/PluginDevice.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::cli {

namespace {

using device::FoundDevice;
using Json = nlohmann::ordered_json;

constexpr const char* handsWithoutHardware =
    "Hands that need no hardware: the script (inserts at the scenario's speed), mouse and "
    "keyboard\n"
    "(in the window), a recording (replay).\n";

const char* accessWord(device::NodeAccess access)
{
  switch (access) {
    case device::NodeAccess::allowed:
      return "allowed";
    case device::NodeAccess::denied:
      return "denied";
    case device::NodeAccess::absent:
      return "absent";
  }
  return "unknown";
}

std::string ability(const device::DeviceTraits& traits)
{
  std::string text = std::to_string(traits.sensedTranslations) + " shifts and " +
                     std::to_string(traits.sensedRotations) + " turns sensed, ";
  if (traits.rendersForce)
    text += "force on " + std::to_string(traits.actuatedTranslations) + " axes up to " +
            fixed(traits.maxForce, 1) + " N";
  else
    text += "no force";
  if (traits.maxTorque > 0.0)
    text += ", torque on " + std::to_string(traits.actuatedRotations) + " axes up to " +
            fixed(traits.maxTorque * 1e3, 0) + " mN.m";
  return text + ", a report every " + fixed(traits.nominalPeriod * 1e3, 1) + " ms";
}

void printProfile(const device::KnownDevice& known)
{
  print("    Profile {}, confidence {}.\n", known.file, known.confidence);
  if (!known.caution.empty()) print("    {}\n", known.caution);
}

void printDevice(const FoundDevice& found)
{
  const device::HidNode& node = found.node;
  print("{}  {}  {}\n", node.path, device::identityText(node.identity),
        node.name.empty() ? found.kind : node.name);
  if (!node.place.empty()) print("    At {}.\n", node.place);
  if (found.known)
    print("    {}, a {}: {}\n", found.known->name, found.kind, ability(found.known->traits));
  if (found.known) printProfile(*found.known);
  print("    {}\n", found.isUsable() ? "It may be opened." : found.obstacle);
}

/// What a named profile states, for its author, who may have no device at hand.
void printSummary(const device::ProfileSummary& profile, bool isFitted)
{
  const device::KnownDevice& known = profile.device;
  print("{}: {}, kind \"{}\", confidence {}\n", known.file, known.name, profile.kind,
        known.confidence);
  print("    {}\n", ability(known.traits));
  print("    For {}.\n", profile.matches);
  if (!isFitted) print("    The profile is valid. No connected device fits it.\n");
}

void printPlugin(const device::FoundPlugin& plugin)
{
  print("{}  {}\n", plugin.file, plugin.name);
  if (!plugin.isUsable())
    return print("    {}\n", static_cast<const std::string&>(plugin.obstacle));
  print("    A plug-in: {}\n", ability(plugin.traits));
  print(
      "    It was loaded. Whether its device is connected shows when it is opened: 'perilymph-cli "
      "devices --plugin {}'.\n",
      plugin.file);
}

Json described(const device::FoundPlugin& plugin)
{
  Json json = {{"file", plugin.file.string()},
               {"name", plugin.name},
               {"usable", plugin.isUsable()},
               {"obstacle", static_cast<const std::string&>(plugin.obstacle)}};
  if (!plugin.isUsable()) return json;
  const device::DeviceTraits& traits = plugin.traits;
  json["renders_force"] = traits.rendersForce;
  json["max_force_N"] = traits.maxForce;
  json["max_torque_N_m"] = traits.maxTorque;
  json["nominal_period_s"] = traits.nominalPeriod;
  return json;
}

Json described(const FoundDevice& found)
{
  const device::HidNode& node = found.node;
  Json json;
  json["node"] = node.path.string();
  json["bus"] = node.bus;
  json["place"] = node.place;
  json["vendor_id"] = node.identity.vendor;
  json["product_id"] = node.identity.product;
  json["interface"] = node.identity.interfaceNumber;
  json["name"] = node.name;
  json["kind"] = found.kind;
  json["descriptor_bytes"] = node.descriptor.size();
  json["access"] = accessWord(node.access);
  json["udev_rule"] = device::udevRule(node.identity.vendor, node.identity.product);
  json["usable"] = found.isUsable();
  json["obstacle"] = found.obstacle;
  if (!found.known) {
    json["profile"] = nullptr;
    return json;
  }
  const device::DeviceTraits& traits = found.known->traits;
  json["profile"] = {{"name", found.known->name},
                     {"file", found.known->file},
                     {"confidence", found.known->confidence},
                     {"caution", found.known->caution},
                     {"renders_force", traits.rendersForce},
                     {"max_force_N", traits.maxForce},
                     {"nominal_period_s", traits.nominalPeriod},
                     {"max_stiffness_N_m", traits.maxStiffness}};
  return json;
}

/// What kept a force below the intended one.
std::vector<std::string> limitsText(std::uint32_t limits)
{
  std::vector<std::string> text;
  for (const auto& [bit, sentence] : std::initializer_list<std::pair<std::uint32_t, const char*>>{
           {haptics::nearWorkspaceEnd, "near the end of the device's reach"},
           {haptics::passivityActed, "the handle moved with the force and was damped"},
           {haptics::rampingIn, "the force was still fading in"},
           {haptics::forceSlewed, "the rate of change was limited"},
           {haptics::forceClamped, "the device's maximum"},
           {haptics::staleSample, "reports were missing"}})
    if ((limits & bit) != 0) text.emplace_back(sentence);
  return text;
}

Json describedForces(const TrialOutcome& trial)
{
  Json axes = Json::array();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& axis = trial.forces[i];
    if (!axis.isActuated) continue;
    axes.push_back({{"axis", std::string(1, "xyz"[i])},
                    {"peak_N", axis.peak},
                    {"moved_mm", axis.moved * 1e3},
                    {"done", axis.isDone},
                    {"limited_by", limitsText(axis.limits)}});
  }
  return axes;
}

Json describedTorques(const TrialOutcome& trial)
{
  Json axes = Json::array();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& axis = trial.forces[i + 3];
    if (!axis.isActuated) continue;
    axes.push_back({{"axis", std::string(1, "xyz"[i])},
                    {"peak_N_m", axis.peak},
                    {"turned_deg", axis.moved * 180.0 / pi},
                    {"done", axis.isDone},
                    {"limited_by", limitsText(axis.limits)}});
  }
  return axes;
}

std::string errorOf(const TrialOutcome& trial) { return trial.health ? trial.health->error : ""; }

/// Results of a plug-in's device, whose connection is unknown.
Json describedPlugin(const TrialOutcome& trial)
{
  return {{"name", trial.traits.name},
          {"renders_force", trial.traits.rendersForce},
          {"max_force_N", trial.traits.maxForce},
          {"nominal_period_s", trial.traits.nominalPeriod},
          {"rate_per_s", trial.health ? trial.health->reading.overall.rate : 0.0},
          {"samples", trial.samples},
          {"fresh", trial.fresh},
          {"stiffest_coupling_N_m", trial.stiffness},
          {"passive_handle_damping_N_s_m", trial.passiveHandleDamping},
          {"force_axes", trial.axes},
          {"force_axes_shown", trial.axesShown()},
          {"force_intended_N", trial.greatest},
          {"forces", describedForces(trial)},
          {"torques", describedTorques(trial)},
          {"untested", trial.untested},
          {"button_pressed", trial.wasPressed},
          {"passed", trial.shortcoming().empty()},
          {"error", errorOf(trial)}};
}

Json described(const TrialOutcome& trial)
{
  if (trial.isPlugin || !trial.health) return describedPlugin(trial);
  const device::DeviceHealth& health = *trial.health;
  return {{"period_s", health.period},
          {"period_measured", health.isPeriodMeasured},
          {"rate_per_s", health.reading.overall.rate},
          {"interval_median_s", health.reading.overall.intervalMedian},
          {"interval_p99_s", health.reading.overall.intervalP99},
          {"interval_max_s", health.reading.overall.intervalMax},
          {"reconnections", health.reconnections},
          {"reports", health.reading.fresh},
          {"lost", health.reading.lost},
          {"duplicates", health.reading.duplicates},
          {"old", health.reading.old},
          {"foreign", health.reading.foreign},
          {"write_median_s", health.writing.timeMedian},
          {"write_p99_s", health.writing.timeP99},
          {"write_max_s", health.writing.timeMax},
          {"delay_s", health.delay},
          {"round_trip_s", health.roundTrip},
          {"round_trip_measured", health.isRoundTripMeasured},
          {"guarded", health.isGuarded},
          {"guard_obstacle", health.guardObstacle},
          {"writer_real_time", health.writing.hasRealTimePriority},
          {"stiffest_coupling_N_m", trial.stiffness},
          {"passive_handle_damping_N_s_m", trial.passiveHandleDamping},
          {"force_axes", trial.axes},
          {"force_axes_shown", trial.axesShown()},
          {"force_intended_N", trial.greatest},
          {"forces", describedForces(trial)},
          {"torques", describedTorques(trial)},
          {"untested", trial.untested},
          {"button_pressed", trial.wasPressed},
          {"passed", trial.shortcoming().empty()},
          {"error", health.error}};
}

void printForce(const TrialOutcome& trial)
{
  print("{:18} rendered on {} of {} axes{}\n", "force", trial.axesShown(), trial.axes,
        trial.untested.empty() ? "" : "; " + trial.untested);
  for (std::size_t i = 0; i < trial.forces.size(); ++i) {
    const auto& axis = trial.forces[i];
    if (!axis.isActuated) continue;
    const bool isForce = i < 3;
    std::string limits;
    for (const std::string& limit : limitsText(axis.limits)) limits += "; " + limit;
    const std::string against = axis.isAgainst ? " against it" : "";
    const std::string moved =
        axis.moved == 0.0 ? "; the handle did not move: hold it loosely to see the direction"
        : isForce
            ? "; the handle moved " + fixed(axis.moved * 1e3, 2) + " mm" + against
            : "; the handle turned " + fixed(axis.moved * 180.0 / pi, 2) + " degrees" + against;
    const std::string written =
        isForce ? fixed(axis.peak, 2) + " N of " + fixed(trial.greatest, 2) + " N written"
                : fixed(axis.peak * 1e3, 1) + " mN.m of " + fixed(trial.greatestTorque * 1e3, 1) +
                      " mN.m written";
    print("{:18} {}{}: {}\n", "", isForce ? "" : "about ", std::string(1, "xyz"[i % 3]),
          !axis.isDone ? "not tested" : written + (axis.peak > 0.0 ? moved : "") + limits);
  }
}

/// From which damping of the handle on the coupling gives no energy back by itself.
std::string passiveFrom(const TrialOutcome& trial)
{
  return ", passive in a handle damped by " + fixed(trial.passiveHandleDamping, 2) +
         " N.s/m or more";
}

void printReports(const device::ReportTiming& timing)
{
  const auto ms = [](double time) { return fixed(time * 1e3, 3); };
  print("{:18} {}/s; interval median {} ms, 99 % below {} ms, maximum {} ms\n", "reports",
        fixed(timing.rate, 1), ms(timing.intervalMedian), ms(timing.intervalP99),
        ms(timing.intervalMax));
}

void printButton(const TrialOutcome& trial)
{
  if (trial.canBePressed)
    print("{:18} {}\n", "button", trial.wasPressed ? "pressed" : "not pressed");
}

/// Prints the verdict, and returns it as the command's status: an error if the test was not passed.
Result<void> printVerdict(const TrialOutcome& trial, const std::string& name)
{
  const std::string shortcoming = trial.shortcoming();
  print("{:18} {}\n", "result", shortcoming.empty() ? "passed" : "not passed: " + shortcoming);
  if (shortcoming.empty()) return {};
  return Error{"%1 did not pass the test: %2.", name, shortcoming};
}

void printPluginTrial(const TrialOutcome& trial)
{
  print("{}: {}\n", trial.traits.name, ability(trial.traits));
  print("{:18} {} of {} were fresh and valid\n", "samples", trial.fresh, trial.samples);
  if (trial.health) printReports(trial.health->reading.overall);
  printButton(trial);
  if (!errorOf(trial).empty()) print("{:18} {}\n", "", errorOf(trial));
  if (trial.axes == 0) return;
  print("{:18} stiffest coupling {} N/m{}\n", "by its traits", fixed(trial.stiffness, 0),
        passiveFrom(trial));
  printForce(trial);
}

void printTrial(const TrialOutcome& trial)
{
  if (trial.isPlugin || !trial.health) return printPluginTrial(trial);
  const device::DeviceHealth& health = *trial.health;
  const device::ReadingFigures& reading = health.reading;
  const auto ms = [](double time) { return fixed(time * 1e3, 3); };
  printReports(reading.overall);
  print("{:18} {} fresh, {} lost, {} repeated, {} outdated, {} invalid\n", "", reading.fresh,
        reading.lost, reading.duplicates, reading.old, reading.foreign);
  if (health.reconnections > 0)
    print("{:18} {} reconnections during the test\n", "", health.reconnections);
  if (!health.error.empty()) print("{:18} {}\n", "", health.error);
  printButton(trial);
  if (trial.axes == 0) return;
  const device::WritingFigures& writing = health.writing;
  print("{:18} median {} ms, 99 % below {} ms, maximum {} ms\n", "force output",
        ms(writing.timeMedian), ms(writing.timeP99), ms(writing.timeMax));
  if (!writing.hasRealTimePriority)
    print("{:18} without real-time priority: see modules/realtime/README.md\n", "");
  print("{:18} round trip {}{} ms; stiffest coupling {} N/m{}\n", "delay",
        health.isRoundTripMeasured ? "" : "at most ", ms(health.roundTrip),
        fixed(trial.stiffness, 0), passiveFrom(trial));
  print("{:18} {}\n", "on failure",
        health.isGuarded ? "a guard process removes the force" : health.guardObstacle);
  printForce(trial);
}

/// The HID device to test: "3" is hidraw3, whether it can be used or not.
Result<FoundDevice> deviceCalled(const device::DeviceSurvey& survey, const std::string& name)
{
  if (name.find_first_not_of("0123456789") != std::string::npos)
    return device::findDevice(survey, name);
  const std::string node = "hidraw" + name;
  for (const FoundDevice& found : survey.devices)
    if (found.node.path.filename() == node) return found;
  return Error{"There is no " + node + ". 'perilymph-cli devices' shows those there are."};
}

/// Writes a report, if it was requested, whatever the outcome.
Result<void> finish(const Result<void>& outcome, Json json, const std::string& file)
{
  if (file.empty()) return outcome;
  if (!outcome) json["error"] = static_cast<const std::string&>(outcome.error().message);
  const auto written = writeWhole(file, jsonText(json));
  return written ? outcome : written;
}

/// Tests a plug-in, independently of HID devices.
Result<void> tryOut(const std::filesystem::path& plugin, const std::string& file)
{
  Json json = {{"version", version()}, {"plugin", plugin.string()}};
  const auto trial = tryPlugin(plugin);
  if (!trial) return finish(trial.error(), json, file);
  printTrial(*trial);
  const auto verdict = printVerdict(*trial, trial->traits.name);
  json["test"] = described(*trial);
  return finish(verdict, json, file);
}

Result<void> tryOut(const FoundDevice& found, const DevicesOptions& options, Json& json)
{
  if (found.known) printProfile(*found.known);
  const auto trial = tryDevice(found, options.capture);
  if (!trial) return trial.error();
  json["test"] = described(*trial);
  if (found.known) json["test"]["profile"] = found.known->file;
  printTrial(*trial);
  const auto verdict = printVerdict(*trial, found.name());
  if (trial->health && trial->health->reading.fresh == 0)
    return Error{found.name() +
                 " sent no report during the test, so nothing was tested. Move it; check its cable "
                 "and, in its profile, 'reporting' and [input]."};
  return verdict;
}

void printAll(const device::DeviceSurvey& survey, const std::vector<device::FoundPlugin>& plugins)
{
  if (survey.profile)
    printSummary(*survey.profile,
                 std::any_of(survey.devices.begin(), survey.devices.end(),
                             [](const FoundDevice& found) { return found.known.has_value(); }));
  if (survey.devices.empty()) print("No HID device is connected.\n");
  for (const FoundDevice& found : survey.devices) printDevice(found);
  for (const device::FoundPlugin& plugin : plugins) printPlugin(plugin);
  if (plugins.empty()) print("No plug-in is installed.\n");
  print("Plug-ins are installed in {}, for all users in {}.\n", device::pluginFolders().front(),
        device::pluginFolders().back());
  print(handsWithoutHardware);
}

}  // namespace

Result<void> devices(const DevicesOptions& options)
{
  if (!options.replay.empty()) return replayDevice(options.replay, options.json);
  if (!options.plugin.empty()) return tryOut(options.plugin, options.json);
  const device::SystemRoots roots = device::systemRoots();
  const auto surveyed = options.profile.empty()
                            ? Result<device::DeviceSurvey>(device::surveyDevices(roots))
                            : device::surveyDevices(roots, options.profile);
  if (!surveyed) return surveyed.error();
  const device::DeviceSurvey& survey = *surveyed;
  for (const std::string& error : survey.errors) printError("{}\n", error);
  Json json;
  json["version"] = version();
  json["build"] = buildId();
  json["devices"] = Json::array();
  for (const FoundDevice& found : survey.devices) json["devices"].push_back(described(found));
  json["profile_errors"] = survey.errors;
  json["plugins"] = Json::array();

  Result<void> outcome;
  if (options.test.empty()) {
    const std::vector<device::FoundPlugin> plugins = device::surveyPlugins();
    for (const device::FoundPlugin& plugin : plugins) json["plugins"].push_back(described(plugin));
    printAll(survey, plugins);
  } else {
    const auto found = deviceCalled(survey, options.test);
    if (!found) {
      const auto plugins = device::surveyPlugins();
      const auto chosen = device::pluginNamed(plugins, options.test);
      if (!chosen) return chosen.error();
      if (*chosen != nullptr) return tryOut((*chosen)->file, options.json);
      std::string names;
      for (const device::FoundPlugin& plugin : plugins)
        if (plugin.isUsable())
          names += (names.empty() ? " Installed plug-ins: " : ", ") + plugin.name;
      return Error{found.error().message + names + (names.empty() ? "" : ".")};
    }
    outcome = tryOut(*found, options, json);
  }
  return finish(outcome, json, options.json);
}

}  // namespace perilymph::cli
