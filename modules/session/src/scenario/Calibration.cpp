// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Calibration.h"

#include <algorithm>

#include "perilymph/foundation/TomlQuoted.h"
#include "perilymph/foundation/TomlReader.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

namespace {

// [N.m^2]; see uncalibrated().
constexpr double styletLow = 0.82e-6, styletHigh = 4.2e-6;
// The order of a carrier's EI is an estimate: half of the smallest value reported for an array.
constexpr double carrierLow = 0.1e-6, carrierHigh = 3e-6;
// Of the whole array with its stylet in: it appears straight, though "slightly curved" (Todd and
// Naghdy, section IV). The angle is not printed; a choice.
constexpr Angle maxBend = degrees(10);

using Bending = electrode::AlongArray<BendingStiffness>;

/// Angle by which the free carrier bends along the stylet [rad].
double freeBend(const electrode::ArrayDesign& array)
{
  constexpr int pieces = 1000;
  const Length piece = (1.0 / pieces) * (array.length - array.stylet.fromTip);
  double bend = 0.0;
  for (int i = 0; i < pieces; ++i)
    bend += array.restCurvature.at(array.stylet.fromTip + (i + 0.5) * piece).si() * piece.si();
  return bend;
}

void scale(Bending& bending, double factor)
{
  for (BendingStiffness& value : bending.value) value = factor * value;
}

FittedValue readValue(TomlReader& reader, const char* key)
{
  TomlReader table = reader.table(key);
  FittedValue fitted;
  fitted.low = table.number("low", {0.0, 100.0});
  fitted.high = table.number("high", {fitted.low, 100.0});
  fitted.value = table.number("value", {fitted.low, fitted.high});
  fitted.standardDeviation = table.number("sd", {0.0, 100.0});
  return fitted;
}

std::string valueText(const char* key, const FittedValue& fitted)
{
  return std::string("\n[") + key + "]\nvalue = " + tomlNumber(fitted.value) +
         "\nsd = " + tomlNumber(fitted.standardDeviation) +
         "     # 0: not fitted, or held by a bound" + "\nlow = " + tomlNumber(fitted.low) +
         "   # physical bounds" + "\nhigh = " + tomlNumber(fitted.high) + "\n";
}

}  // namespace

Calibration uncalibrated(const electrode::ArrayDesign& array)
{
  Calibration calibration;
  calibration.array = array.name;
  const auto [minimum, maximum] =
      std::minmax_element(array.bending.value.begin(), array.bending.value.end());
  FittedValue& scale = calibration.stiffnessScale;
  // The array's own value is always possible, so the bounds include 1.
  scale.low = std::min(1.0, carrierLow / minimum->si());
  scale.high = std::max(1.0, carrierHigh / maximum->si());
  if (array.hasStylet && array.stylet.bending.si() > 0.0) {
    scale.low = std::min(1.0, std::max(scale.low, styletLow / array.stylet.bending.si()));
    scale.high = std::max(1.0, std::min(scale.high, styletHigh / array.stylet.bending.si()));
    FittedValue& curvature = calibration.residualCurvature;
    curvature.value = array.stylet.residualCurvature;
    const double bend = freeBend(array);
    const double fraction = bend > maxBend.si() ? maxBend.si() / bend : 1.0;
    curvature.high = std::max(fraction, curvature.value);
  }
  return calibration;
}

electrode::ArrayDesign calibrated(electrode::ArrayDesign array, double stiffnessScale,
                                  double residualCurvature)
{
  scale(array.bending, stiffnessScale);
  scale(array.bendingAcross, stiffnessScale);
  if (array.wires) array.wires->modulus = stiffnessScale * array.wires->modulus;
  if (array.taper) array.taper->carrier = stiffnessScale * array.taper->carrier;
  if (array.twisting) scale(*array.twisting, stiffnessScale);
  if (!array.hasStylet) return array;
  array.stylet.bending = stiffnessScale * array.stylet.bending;
  array.stylet.residualCurvature = residualCurvature;
  return array;
}

Result<Calibration> loadCalibration(const std::filesystem::path& file)
{
  auto reader = TomlReader::open(file);
  if (!reader) return reader.error();
  Calibration calibration;
  calibration.label = reader->text("label");
  calibration.array = reader->text("array");
  calibration.source = reader->text("source");
  calibration.stiffnessScale = readValue(*reader, "stiffness_scale");
  calibration.residualCurvature = readValue(*reader, "residual_curvature_fraction");
  for (TomlReader& table : reader->tables("force")) {
    FittedForce force;
    force.travel = millimeters(table.number("travel_mm", {0.0, 60.0})).si();
    force.wanted = table.number("wanted_N", {-5.0, 5.0});
    force.found = table.number("found_N", {-5.0, 5.0});
    calibration.forces.push_back(force);
  }
  if (const auto done = reader->finish(); !done) return done.error();
  return calibration;
}

std::string calibrationText(const Calibration& calibration)
{
  std::string text =
      "# Fitted numbers for an array, and where they come from. Written by perilymph-cli "
      "calibrate.\n\n"
      "label = " +
      tomlQuoted(calibration.label) + "\narray = " + tomlQuoted(calibration.array) +
      "\nsource = " + tomlQuoted(calibration.source) + "\n";
  text += valueText("stiffness_scale", calibration.stiffnessScale);
  text += valueText("residual_curvature_fraction", calibration.residualCurvature);
  for (const FittedForce& force : calibration.forces)
    text += "\n[[force]]  # used by the fit\ntravel_mm = " +
            tomlNumber(exactMillimeters(meters(force.travel))) +
            "\nwanted_N = " + tomlNumber(force.wanted) + "\nfound_N = " + tomlNumber(force.found) +
            "\n";
  return text;
}

}  // namespace perilymph::session
