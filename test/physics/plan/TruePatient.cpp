// SPDX-License-Identifier: BSD-3-Clause
#include "TruePatient.h"

#include <array>
#include <string>
#include <utility>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/analysis/RandomStream.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::test {

namespace {

// Errors of A, B and H as a clinical CT gives them: half a voxel of 0.3 mm, H somewhat more.
constexpr Length errorOfA = millimeters(0.15), errorOfB = millimeters(0.15),
                 errorOfH = millimeters(0.2);
/// Waves of the radius: standard deviation of each amplitude, as a fraction.
constexpr double waveDeviation = 0.01;
/// Rise of the center line: 3.26 +- 0.24 mm (Medan), as a fraction.
constexpr double riseDeviation = 0.07;
/// Size of the sections at base and apex: the middle of 9 to 15 % (Avci et al. 2014).
constexpr double sectionDeviation = 0.12;

/// The true shape as factors of the template's, over the angle.
struct Factors {
  anatomy::HalfDiameters half;
  std::array<double, 3> amplitude{}, phase{};
  double rise = 1.0, base = 1.0, apex = 1.0;
  double size = 1.0;  ///< Common factor of radius and height.

  double radius(double angle) const
  {
    double wave = 1.0;
    for (std::size_t k = 0; k < amplitude.size(); ++k)
      wave += amplitude[k] * sineCosine(0.5 * static_cast<double>(k + 1) * angle + phase[k]).sine;
    return size * wave * anatomy::outerWallRadius(half, radians(angle)) /
           anatomy::outerWallRadius(anatomy::meanHalfDiameters(), radians(angle));
  }
  double section(double alongScala) const { return base + alongScala * (apex - base); }
};

Factors drawFactors(std::uint64_t seed, std::uint64_t number)
{
  analysis::RandomStream random(seed, number, 1);
  Factors factors;
  factors.half = anatomy::sampleHalfDiameters(seed + number);
  for (double& amplitude : factors.amplitude)
    amplitude = random.normal(0.0, waveDeviation, -3.0 * waveDeviation, 3.0 * waveDeviation);
  for (double& phase : factors.phase) phase = random.between(0.0, 2.0 * pi);
  factors.rise = random.normal(1.0, riseDeviation, 0.8, 1.2);
  factors.base = random.normal(1.0, sectionDeviation, 0.75, 1.25);
  factors.apex = random.normal(1.0, sectionDeviation, 0.75, 1.25);
  return factors;
}

anatomy::SectionTables deformed(anatomy::SectionTables tables, const Factors& factors)
{
  const std::size_t count = tables.centerRadius.size();
  const auto directions = static_cast<std::size_t>(tables.directions);
  for (std::size_t i = 0; i < count; ++i) {
    const double radial = factors.radius(static_cast<double>(i) * tables.step);
    const double size = factors.section(static_cast<double>(i) / static_cast<double>(count - 1));
    const double outer = tables.centerRadius[i] + tables.wallRadius[i * directions];
    const auto moved = [&](double r) { return radial * (outer - size * (outer - r)); };
    tables.centerRadius[i] = moved(tables.centerRadius[i]);
    tables.planRadius[i] = moved(tables.planRadius[i]);
    tables.centerHeight[i] *= factors.size * factors.rise;
    for (std::size_t k = 0; k < directions; ++k)
      tables.wallRadius[i * directions + k] *= radial * size;
    for (auto* values : {&tables.membraneInner, &tables.membraneOuter, &tables.membraneHeight})
      (*values)[i] *= radial * size;
  }
  return tables;
}

double measureNamed(const anatomy::ScalaTympani& scala, const std::string& key)
{
  for (const analysis::Measure& each : analysis::measure(scala))
    if (each.key == key) return each.value;
  return 0.0;
}

}  // namespace

Result<TruePatient> truePatient(std::uint64_t seed, std::uint64_t number)
{
  const auto clark = anatomy::buildAnatomy({anatomy::AnatomySource::clark, {}, Length{}}, "truth");
  if (!clark) return clark.error();
  TruePatient patient;
  // The template's lumen is larger than the population's: its size follows from A + B.
  Factors factors = drawFactors(seed, number);
  const auto raw =
      analysis::basalDiameters(anatomy::ScalaTympani(deformed((*clark)->tables(), factors)));
  factors.size = (factors.half.a() + factors.half.b()) / (raw.a + raw.b);
  patient.anatomy =
      std::make_shared<const anatomy::ScalaTympani>(deformed((*clark)->tables(), factors));
  const analysis::BasalDiameters basal = analysis::basalDiameters(*patient.anatomy);
  patient.truth = {basal.a, basal.b, millimeters(measureNamed(*patient.anatomy, "H_mm"))};
  analysis::RandomStream random(seed, number, 2);
  const auto measured = [&](Length truth, Length error) {
    return meters(random.normal(truth.si(), error.si(), truth.si() - 3.0 * error.si(),
                                truth.si() + 3.0 * error.si()));
  };
  patient.measured.label = "truth-" + std::to_string(number);
  patient.measured.basalTurn =
      anatomy::BasalTurn{measured(patient.truth.a, errorOfA), measured(patient.truth.b, errorOfB),
                         measured(*patient.truth.h, errorOfH)};
  patient.measured.errors = anatomy::BasalTurnErrors{errorOfA, errorOfB, errorOfH};
  return patient;
}

}  // namespace perilymph::test
