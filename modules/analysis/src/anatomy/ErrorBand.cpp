// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ErrorBand.h"

#include <cmath>

namespace perilymph::analysis {

namespace {

/// The patients that differ from a given one in a single length, changed by its error.
std::vector<anatomy::Patient> movedByOne(const anatomy::Patient& patient, Length assumed)
{
  std::vector<anatomy::Patient> moved;
  const anatomy::BasalTurnErrors errors = errorsOf(patient, assumed);
  Length step = assumed;
  const auto move = [&](auto change) {
    anatomy::Patient other = patient;
    change(other);
    // upward if allowed, else downward
    if (!anatomy::checkPatient(other)) {
      other = patient;
      step = -step;
      change(other);
      step = -step;
    }
    moved.push_back(other);
  };
  if (patient.basalTurn) {
    step = errors.a;
    move([&](anatomy::Patient& p) { p.basalTurn->a = p.basalTurn->a + step; });
    step = errors.b;
    move([&](anatomy::Patient& p) { p.basalTurn->b = p.basalTurn->b + step; });
    step = errors.h.value_or(assumed);
    if (patient.basalTurn->h)
      move([&](anatomy::Patient& p) { p.basalTurn->h = *p.basalTurn->h + step; });
  } else {
    move([&](anatomy::Patient& p) { p.scalaTympaniLength = p.scalaTympaniLength + step; });
    move([&](anatomy::Patient& p) { p.roundWindowWidth = p.roundWindowWidth + step; });
    move([&](anatomy::Patient& p) { p.roundWindowHeight = p.roundWindowHeight + step; });
  }
  return moved;
}

}  // namespace

anatomy::BasalTurnErrors errorsOf(const anatomy::Patient& patient, Length assumed)
{
  if (!patient.errors) return {assumed, assumed, assumed};
  anatomy::BasalTurnErrors errors = *patient.errors;
  errors.h = errors.h.value_or(assumed);
  return errors;
}

Result<std::vector<double>> errorBands(
    const anatomy::Cochlea& cochlea, const std::vector<Measure>& measures, Length error,
    const std::function<std::vector<Measure>(const anatomy::ScalaTympani&)>& measuring)
{
  if (!isScaledBy(cochlea.source, cochlea.patient)) return std::vector<double>{};

  std::vector<double> bands(measures.size(), 0.0);
  for (const anatomy::Patient& patient : movedByOne(cochlea.patient, error)) {
    const auto scala =
        anatomy::buildAnatomy({cochlea.source, patient, cochlea.leadIn}, patient.label);
    if (!scala) return scala.error();
    const std::vector<Measure> moved = measuring(**scala);
    for (std::size_t i = 0; i < bands.size() && i < moved.size(); ++i) {
      const double change = moved[i].value - measures[i].value;
      bands[i] += change * change;
    }
  }
  for (double& band : bands) band = std::sqrt(band);
  return bands;
}

}  // namespace perilymph::analysis
