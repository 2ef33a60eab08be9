// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/Variability.h"

#include <algorithm>
#include <cmath>

#include "perilymph/analysis/RandomStream.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::validation {

namespace {

std::uint32_t bitOf(SpreadSource source) { return 1u << static_cast<std::uint32_t>(source); }

/// A table of one source of variation, with the provenance of its values.
TomlReader sourceTable(TomlReader& file, const char* key, Variability& variability)
{
  TomlReader table = file.table(key);
  variability.provenance.emplace_back(key, table.text("source"));
  return table;
}

void readSampling(TomlReader& file, Variability& v)
{
  TomlReader sampling = sourceTable(file, "sampling", v);
  v.samplePeriod = milliseconds(sampling.number("period_ms", {1.0, 1000.0}));
  v.timeStep = milliseconds(sampling.number("dt_ms", {0.1, 10.0}));
  v.knotSpacing = millimeters(sampling.number("knot_spacing_mm", {0.2, 10.0}));
  const double steps = v.samplePeriod / v.timeStep;
  if (std::fabs(steps - std::round(steps)) > 1e-9 * steps)
    sampling.refuse("dt_ms", "dt_ms does not divide period_ms without rest. Choose another one.");
}

void readStart(TomlReader& file, Variability& v)
{
  TomlReader start = sourceTable(file, "start", v);
  v.startLow = millimeters(start.number("low_mm", {-10.0, 10.0}));
  v.startHigh = millimeters(start.number("high_mm", {-10.0, 10.0}));
  if (v.startHigh < v.startLow) start.refuse("high_mm", "high_mm is below low_mm. Exchange them.");
}

}  // namespace

const char* spreadSourceName(SpreadSource source) noexcept
{
  switch (source) {
    case SpreadSource::start:
      return "start";
    case SpreadSource::alignment:
      return "alignment";
    case SpreadSource::motion:
      return "motion";
    case SpreadSource::curvature:
      return "curvature";
    case SpreadSource::friction:
      return "friction";
    case SpreadSource::noise:
      break;
  }
  return "noise";
}

SpreadSources SpreadSources::all()
{
  SpreadSources sources;
  for (const SpreadSource source : allSpreadSources) sources.bits_ |= bitOf(source);
  return sources;
}

SpreadSources SpreadSources::only(SpreadSource source)
{
  SpreadSources sources;
  sources.bits_ = bitOf(source);
  return sources;
}

bool SpreadSources::has(SpreadSource source) const noexcept { return (bits_ & bitOf(source)) != 0; }

Result<Variability> loadVariability(const std::filesystem::path& file)
{
  auto opened = TomlReader::open(file);
  if (!opened) return opened.error();
  TomlReader& reader = *opened;
  Variability v;
  v.label = reader.text("label");
  v.scenario = reader.text("scenario");
  readSampling(reader, v);
  readStart(reader, v);
  TomlReader alignment = sourceTable(reader, "alignment", v);
  v.tiltDeviation = degrees(alignment.number("tilt_sd_deg", {0.0, 8.0}));
  v.turnDeviation = degrees(alignment.number("turn_sd_deg", {0.0, 8.0}));
  TomlReader motion = sourceTable(reader, "motion", v);
  v.speedDeviation = motion.number("speed_sd_fraction", {0.0, 0.3});
  v.tremorFrequency = motion.number("tremor_Hz", {0.0, 30.0});
  v.tremorAmplitude = millimeters(motion.number("tremor_amplitude_mm", {0.0, 0.5}));
  TomlReader curvature = sourceTable(reader, "curvature", v);
  v.curvatureDeviation = curvature.number("residual_sd_fraction", {0.0, 0.5});
  TomlReader friction = sourceTable(reader, "friction", v);
  v.frictionDeviation = friction.number("sd_fraction", {0.0, 1.0});
  TomlReader noise = sourceTable(reader, "noise", v);
  v.noiseDeviation = newtons(noise.number("sd_N", {0.0, 0.1}));
  if (const auto done = reader.finish(); !done) return done.error();
  return v;
}

DrawnInsertion drawInsertion(const session::InsertionParameters& nominal,
                             const Variability& variability, SpreadSources sources,
                             std::uint64_t seed, std::uint64_t number)
{
  DrawnInsertion drawn;
  drawn.parameters = nominal;
  drawn.parameters.timeStep = variability.timeStep;
  drawn.push.speed = nominal.speed.si();
  drawn.seed = seed;
  drawn.number = number;
  const auto stream = [&](SpreadSource source) {
    return analysis::RandomStream(seed, number, static_cast<std::uint64_t>(source));
  };
  constexpr double maxDeviates = 3.0;  // in standard deviations: a larger misalignment would have
                                       // been corrected

  if (sources.has(SpreadSource::start)) {
    const double fraction = stream(SpreadSource::start).uniform();
    drawn.parameters.startInside =
        variability.startLow + fraction * (variability.startHigh - variability.startLow);
  }
  if (sources.has(SpreadSource::alignment)) {
    analysis::RandomStream random = stream(SpreadSource::alignment);
    drawn.parameters.approachTilt =
        drawn.parameters.approachTilt +
        random.normal(0.0, 1.0, -maxDeviates, maxDeviates) * variability.tiltDeviation;
    drawn.parameters.approachTurn =
        drawn.parameters.approachTurn +
        random.normal(0.0, 1.0, -maxDeviates, maxDeviates) * variability.turnDeviation;
  }
  if (sources.has(SpreadSource::motion)) {
    analysis::RandomStream random = stream(SpreadSource::motion);
    drawn.push.speed *=
        1.0 + variability.speedDeviation * random.normal(0.0, 1.0, -maxDeviates, maxDeviates);
    drawn.push.tremorAmplitude = variability.tremorAmplitude.si();
    drawn.push.tremorFrequency = variability.tremorFrequency;
    for (double& phase : drawn.push.tremorPhase) phase = random.between(0.0, 2.0 * pi);
  }
  if (sources.has(SpreadSource::curvature) && drawn.parameters.array.hasStylet) {
    analysis::RandomStream random = stream(SpreadSource::curvature);
    double& residual = drawn.parameters.array.stylet.residualCurvature;
    residual += variability.curvatureDeviation * random.normal(0.0, 1.0, -maxDeviates, maxDeviates);
  }
  if (sources.has(SpreadSource::friction)) {
    // log-normal with mean 1 and the given deviation
    const double variance =
        logarithm(1.0 + variability.frictionDeviation * variability.frictionDeviation);
    const double deviate =
        stream(SpreadSource::friction).normal(0.0, 1.0, -maxDeviates, maxDeviates);
    const double factor = exponential(std::sqrt(variance) * deviate - 0.5 * variance);
    mechanics::FrictionLaw& law = drawn.parameters.friction;
    for (double* coefficient :
         {&law.staticCoefficient, &law.kineticCoefficient, &law.stoppingCoefficient})
      *coefficient = std::min(1.0, *coefficient * factor);
    law.bySpeed = law.bySpeed.scaled(factor);
  }
  if (sources.has(SpreadSource::noise)) drawn.noiseDeviation = variability.noiseDeviation.si();
  return drawn;
}

}  // namespace perilymph::validation
