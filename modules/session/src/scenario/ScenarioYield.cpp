// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ScenarioYield.h"

#include "perilymph/session/Csv.h"

namespace perilymph::session {

namespace {

constexpr const char* wiresKey = "wire_yield_MPa";
constexpr const char* styletKey = "stylet_yield_MPa";

// From soft annealed metal to hard-drawn platinum-iridium and steel, with room on both sides.
constexpr Range yield_MPa{20.0, 3000.0};

/// Takes a value within the range that the array's file states, if it states one.
Result<void> take(const char* key, Modulus value, const std::string& file,
                  const electrode::ArrayDesign& array, electrode::YieldStress& stress)
{
  const bool isOutside =
      stress.maximum.si() > 0.0 && (value < stress.minimum || stress.maximum < value);
  if (isOutside)
    return Error{"%1: %2 is %3, and the file of the array %4 states %5 to %6. Set it within them.",
                 file,
                 key,
                 shortestDecimal(inMegapascals(value)),
                 array.name,
                 shortestDecimal(inMegapascals(stress.minimum)),
                 shortestDecimal(inMegapascals(stress.maximum))};
  stress.value = value;
  return {};
}

}  // namespace

AskedYield readYield(TomlReader& reader, ScenarioKeys& keys, mechanics::ModelKind model)
{
  AskedYield asked;
  for (const auto& [key, stress] :
       {std::pair(wiresKey, &asked.wires), std::pair(styletKey, &asked.stylet)}) {
    if (!reader.has(key)) continue;
    if (model == mechanics::ModelKind::points)
      reader.refuse(key, std::string(key) +
                             " is given, and the published model of points does not yield. Set "
                             "model to 'rod', or leave the key out.");
    *stress = megapascals(keys.number(key, yield_MPa, yield_MPa.high));
  }
  return asked;
}

Result<void> applyYield(const AskedYield& asked, const std::string& file, ScenarioContent& scenario)
{
  electrode::ArrayDesign& array = scenario.parameters.array;
  if (asked.wires) {
    if (!array.wires)
      return Error{
          "%1: %2 is given, and the file of the array %3 has no table [wires]. State its wires "
          "there, or leave the key out.",
          file, wiresKey, array.name};
    const auto done = take(wiresKey, *asked.wires, file, array, array.wires->yieldStress);
    if (!done) return done.error();
  }
  if (asked.stylet) {
    if (!array.hasStylet)
      return Error{"%1: %2 is given, and the array %3 has no stylet. Leave the key out.", file,
                   styletKey, array.name};
    const auto done = take(styletKey, *asked.stylet, file, array, array.stylet.yieldStress);
    if (!done) return done.error();
  }
  // a calibration scales stiffness, not the wire that has it
  if (array.styletYields()) array.stylet.diameter = array.stylet.wireDiameter();
  if (array.yields() && !scenario.calibrationName.empty())
    return Error{
        "%1: the array %2 yields, and the calibration '%3' was fitted with an elastic one: "
        "together "
        "they count one softness twice. Set calibration to \"\", and stiffness_scale to a value "
        "fitted with the yield.",
        file, array.name, scenario.calibrationName};
  return {};
}

}  // namespace perilymph::session
