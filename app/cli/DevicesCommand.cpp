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

void printDevice(const FoundDevice& found)
{
  const device::HidNode& node = found.node;
  print("{}  {}  {}\n", node.path, device::identityText(node.identity),
        node.name.empty() ? found.kind : node.name);
  if (found.known)
    print("    {}, a {}: {}\n", found.known->name, found.kind, ability(found.known->traits));
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
                     {"confidence", found.known->confidence},
                     {"renders_force", traits.rendersForce},
                     {"max_force_N", traits.maxForce},
                     {"nominal_period_s", traits.nominalPeriod},
                     {"max_stiffness_N_m", traits.maxStiffness}};
  return json;
}

/// Results of a plug-in's device, which measures nothing itself.
Json describedPlugin(const TrialOutcome& trial)
{
  return {{"name", trial.traits.name},
          {"renders_force", trial.traits.rendersForce},
          {"max_force_N", trial.traits.maxForce},
          {"nominal_period_s", trial.traits.nominalPeriod},
          {"samples", trial.samples},
          {"fresh", trial.fresh},
          {"stiffest_coupling_N_m", trial.stiffness},
          {"force_axes", trial.axes},
          {"force_axes_shown", trial.axesFelt}};
}

Json described(const TrialOutcome& trial)
{
  if (!trial.health) return describedPlugin(trial);
  const device::DeviceHealth& health = *trial.health;
  return {{"period_s", health.period},
          {"period_measured", health.isPeriodMeasured},
          {"rate_per_s", health.reading.rate},
          {"interval_median_s", health.reading.intervalMedian},
          {"interval_p99_s", health.reading.intervalP99},
          {"interval_max_s", health.reading.intervalMax},
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
          {"force_axes", trial.axes},
          {"force_axes_shown", trial.axesFelt},
          {"error", health.error}};
}

void printForce(const TrialOutcome& trial)
{
  print("{:18} rendered on {} of {} axes{}\n", "force", trial.axesFelt, trial.axes,
        trial.axesFelt < trial.axes ? "; the button was not held" : "");
}

void printPlugin(const TrialOutcome& trial)
{
  print("{}: {}\n", trial.traits.name, ability(trial.traits));
  print("{:18} {} of {} were fresh and valid\n", "samples", trial.fresh, trial.samples);
  if (trial.axes == 0) return;
  print("{:18} stiffest coupling {} N/m\n", "by its traits", fixed(trial.stiffness, 0));
  printForce(trial);
}

void printTrial(const TrialOutcome& trial)
{
  if (!trial.health) return printPlugin(trial);
  const device::DeviceHealth& health = *trial.health;
  const device::ReadingFigures& reading = health.reading;
  const auto ms = [](double time) { return fixed(time * 1e3, 3); };
  print("{:18} {}/s; interval median {} ms, 99 % below {} ms, maximum {} ms\n", "reports",
        fixed(reading.rate, 1), ms(reading.intervalMedian), ms(reading.intervalP99),
        ms(reading.intervalMax));
  print("{:18} {} fresh, {} lost, {} repeated, {} outdated, {} invalid\n", "", reading.fresh,
        reading.lost, reading.duplicates, reading.old, reading.foreign);
  if (!health.error.empty()) print("{:18} {}\n", "", health.error);
  if (trial.axes == 0) return;
  const device::WritingFigures& writing = health.writing;
  print("{:18} median {} ms, 99 % below {} ms, maximum {} ms\n", "force output",
        ms(writing.timeMedian), ms(writing.timeP99), ms(writing.timeMax));
  if (!writing.hasRealTimePriority)
    print("{:18} without real-time priority: see modules/realtime/README.md\n", "");
  print("{:18} round trip {}{} ms; stiffest coupling {} N/m\n", "delay",
        health.isRoundTripMeasured ? "" : "at most ", ms(health.roundTrip),
        fixed(trial.stiffness, 0));
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
Result<Done> tryOut(const std::string& plugin, const std::string& file)
{
  const auto trial = tryPlugin(plugin);
  if (!trial) return trial.error();
  printTrial(*trial);
  if (file.empty()) return Done{};
  const Json json = {{"version", version()}, {"plugin", plugin}, {"test", described(*trial)}};
  return writeWhole(file, jsonText(json));
}

}  // namespace

Result<Done> devices(const DevicesOptions& options)
{
  if (!options.replay.empty()) return replayDevice(options.replay, options.json);
  if (!options.plugin.empty()) return tryOut(options.plugin, options.json);
  const device::DeviceSurvey survey = device::surveyDevices(device::systemRoots());
  Json json;
  json["version"] = version();
  json["devices"] = Json::array();
  for (const FoundDevice& found : survey.devices) json["devices"].push_back(described(found));
  json["profile_errors"] = survey.errors;
  for (const std::string& error : survey.errors) printError("{}\n", error);

  if (options.test) {
    const auto found = deviceOfNumber(survey, *options.test);
    if (!found) return found.error();
    const auto trial = tryDevice(*found, options.capture);
    if (!trial) return trial.error();
    json["test"] = described(*trial);
    printTrial(*trial);
  } else {
    if (survey.devices.empty()) print("No HID device is connected.\n");
    for (const FoundDevice& found : survey.devices) printDevice(found);
    print(handsWithoutHardware);
  }
  if (options.json.empty()) return Done{};
  return writeWhole(options.json, jsonText(json));
}

}  // namespace perilymph::cli
