// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "Commands.h"
#include "DeviceReplay.h"
#include "DeviceTrial.h"
#include "JsonText.h"
#include "Terminal.h"
#include "perilymph/device/DeviceRegistry.h"
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
  if (found.known)
    print("    {}, a {}: {}\n", found.known->name, found.kind, ability(found.known->traits));
  if (found.known) printProfile(*found.known);
  print("    {}\n", found.isUsable() ? "It may be opened." : found.obstacle);
}

Json described(const FoundDevice& found)
{
  const device::HidNode& node = found.node;
  Json json;
  json["node"] = node.path.string();
  json["bus"] = node.bus;
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
  for (int i = 0; i < trial.axes; ++i) {
    const auto& axis = trial.forces[static_cast<std::size_t>(i)];
    axes.push_back({{"axis", std::string(1, "xyz"[i])},
                    {"peak_N", axis.peak},
                    {"moved_mm", axis.moved * 1e3},
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
          {"samples", trial.samples},
          {"fresh", trial.fresh},
          {"stiffest_coupling_N_m", trial.stiffness},
          {"passive_handle_damping_N_s_m", trial.passiveHandleDamping},
          {"force_axes", trial.axes},
          {"force_axes_shown", trial.axesShown()},
          {"force_intended_N", trial.greatest},
          {"forces", describedForces(trial)},
          {"untested", trial.untested},
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
          {"untested", trial.untested},
          {"error", health.error}};
}

void printForce(const TrialOutcome& trial)
{
  print("{:18} rendered on {} of {} axes{}\n", "force", trial.axesShown(), trial.axes,
        trial.untested.empty() ? "" : "; " + trial.untested);
  for (int i = 0; i < trial.axes; ++i) {
    const auto& axis = trial.forces[static_cast<std::size_t>(i)];
    std::string limits;
    for (const std::string& limit : limitsText(axis.limits)) limits += "; " + limit;
    const std::string moved =
        axis.moved > 0.0 ? "; the handle moved " + fixed(axis.moved * 1e3, 2) + " mm"
                         : "; the handle did not move: hold it loosely to see the direction";
    print("{:18} {}: {}\n", "", std::string(1, "xyz"[i]),
          !axis.isDone ? "not tested"
                       : fixed(axis.peak, 2) + " N of " + fixed(trial.greatest, 2) + " N written" +
                             (axis.peak > 0.0 ? moved : "") + limits);
  }
}

/// From which damping of the handle on the coupling gives no energy back by itself.
std::string passiveFrom(const TrialOutcome& trial)
{
  return ", passive in a handle damped by " + fixed(trial.passiveHandleDamping, 2) +
         " N.s/m or more";
}

void printPlugin(const TrialOutcome& trial)
{
  print("{}: {}\n", trial.traits.name, ability(trial.traits));
  print("{:18} {} of {} were fresh and valid\n", "samples", trial.fresh, trial.samples);
  if (!errorOf(trial).empty()) print("{:18} {}\n", "", errorOf(trial));
  if (trial.axes == 0) return;
  print("{:18} stiffest coupling {} N/m{}\n", "by its traits", fixed(trial.stiffness, 0),
        passiveFrom(trial));
  printForce(trial);
}

void printTrial(const TrialOutcome& trial)
{
  if (trial.isPlugin || !trial.health) return printPlugin(trial);
  const device::DeviceHealth& health = *trial.health;
  const device::ReadingFigures& reading = health.reading;
  const auto ms = [](double time) { return fixed(time * 1e3, 3); };
  const device::ReportTiming& timing = reading.overall;
  print("{:18} {}/s; interval median {} ms, 99 % below {} ms, maximum {} ms\n", "reports",
        fixed(timing.rate, 1), ms(timing.intervalMedian), ms(timing.intervalP99),
        ms(timing.intervalMax));
  print("{:18} {} fresh, {} lost, {} repeated, {} outdated, {} invalid\n", "", reading.fresh,
        reading.lost, reading.duplicates, reading.old, reading.foreign);
  if (health.reconnections > 0)
    print("{:18} {} reconnections during the test\n", "", health.reconnections);
  if (!health.error.empty()) print("{:18} {}\n", "", health.error);
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

Result<FoundDevice> deviceOfNumber(const device::DeviceSurvey& survey, int number)
{
  const std::string node = "hidraw" + std::to_string(number);
  for (const FoundDevice& found : survey.devices)
    if (found.node.path.filename() == node) return found;
  return Error{"There is no " + node + ". 'perilymph-cli devices' shows those there are."};
}

/// Tests a plug-in, independently of HID devices.
Result<void> tryOut(const std::string& plugin, const std::string& file)
{
  const auto trial = tryPlugin(plugin);
  if (!trial) return trial.error();
  printTrial(*trial);
  if (file.empty()) return {};
  const Json json = {{"version", version()}, {"plugin", plugin}, {"test", described(*trial)}};
  return writeWhole(file, jsonText(json));
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
  Json json;
  json["version"] = version();
  json["build"] = buildId();
  json["devices"] = Json::array();
  for (const FoundDevice& found : survey.devices) json["devices"].push_back(described(found));
  json["profile_errors"] = survey.errors;
  Result<void> outcome;
  for (const std::string& error : survey.errors) printError("{}\n", error);

  if (options.test) {
    const auto found = deviceOfNumber(survey, *options.test);
    if (!found) return found.error();
    if (found->known) printProfile(*found->known);
    const auto trial = tryDevice(*found, options.capture);
    if (!trial) return trial.error();
    json["test"] = described(*trial);
    if (found->known) json["test"]["profile"] = found->known->file;
    printTrial(*trial);
    if (trial->health && trial->health->reading.fresh == 0)
      outcome = Error{found->name() +
                      " sent no report during the test, so nothing was tested. Move it; check its "
                      "cable and, in its profile, 'reporting' and [input]."};
  } else {
    if (survey.devices.empty()) print("No HID device is connected.\n");
    for (const FoundDevice& found : survey.devices) printDevice(found);
    print(handsWithoutHardware);
  }
  if (options.json.empty()) return outcome;
  const auto written = writeWhole(options.json, jsonText(json));
  return written ? outcome : written;
}

}  // namespace perilymph::cli
