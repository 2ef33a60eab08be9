// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ErrorBand.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Normal.h"

namespace perilymph::analysis {

namespace {

/// A patient that differs from a given one in a single length, by its error.
struct Moved {
  anatomy::Patient patient;
  double sign;  ///< -1 where the length was made shorter.
};

std::vector<Moved> movedByOne(const anatomy::Patient& patient, Length assumed)
{
  std::vector<Moved> moved;
  const anatomy::BasalTurnErrors errors = errorsOf(patient, assumed);
  Length step = assumed;
  const auto move = [&](auto change) {
    Moved other{patient, 1.0};
    change(other.patient);
    // upward if allowed, else downward
    if (!anatomy::checkPatient(other.patient)) {
      other = {patient, -1.0};
      step = -step;
      change(other.patient);
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

/// Correlations of the errors of the lengths that movedByOne() changes.
Eigen::Matrix3d correlationsOf(const anatomy::Patient& patient)
{
  Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
  if (!patient.basalTurn || !patient.errors) return r;
  r(0, 1) = r(1, 0) = patient.errors->ab;
  r(0, 2) = r(2, 0) = patient.errors->ah;
  r(1, 2) = r(2, 1) = patient.errors->bh;
  return r;
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
    const std::function<std::vector<Measure>(const anatomy::ScalaTympani&,
                                             const anatomy::Cochlea&)>& measuring)
{
  if (!isScaledBy(cochlea.source, cochlea.patient)) return std::vector<double>{};

  std::vector<Eigen::Vector3d> changes(measures.size(), Eigen::Vector3d::Zero());
  Eigen::Index length = 0;
  for (const auto& [patient, sign] : movedByOne(cochlea.patient, error)) {
    const anatomy::Cochlea other{cochlea.source, patient, cochlea.leadIn};
    const auto scala = anatomy::buildAnatomy(other, patient.label);
    if (!scala) return scala.error();
    const std::vector<Measure> moved = measuring(**scala, other);
    for (std::size_t i = 0; i < changes.size() && i < moved.size(); ++i)
      changes[i][length] = sign * (moved[i].value - measures[i].value);
    ++length;
  }
  const Eigen::Matrix3d correlations = correlationsOf(cochlea.patient);
  std::vector<double> bands;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const double ofLengths = changes[i].dot(correlations * changes[i]);
    const double ofFormula = measures[i].formulaError * measures[i].formulaError;
    bands.push_back(halfWidth95 * std::sqrt(std::max(0.0, ofLengths) + ofFormula));
  }
  return bands;
}

}  // namespace perilymph::analysis
