// SPDX-License-Identifier: BSD-3-Clause
#include "PlanDraw.h"

#include <cmath>

#include "perilymph/analysis/ArrayTaper.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/analysis/RandomStream.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/electrode/WirePacking.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/session/Calibration.h"

namespace perilymph::planning {

namespace {

/// Uses of random numbers, apart from those of analysis::drawSurgeon().
enum class Draw : std::uint64_t {
  measures = 200,
  approach,
  stiffness,
  shape,
  tissue,
  section,
  course,
  radius,
  height
};

/// Deviates beyond which a measure or a stiffness is not drawn (choice, high).
constexpr double maxDeviates = 3.0;

Length drawLength(analysis::RandomStream& random, Length mean, Length deviation, Length low,
                  Length high)
{
  return meters(random.normal(mean.si(), deviation.si(), low.si(), high.si()));
}

/// A factor with mean 1 and a standard deviation, log-normal.
double factorOf(double deviate, double deviation)
{
  const double variance = logarithm(1.0 + deviation * deviation);
  return exponential(std::sqrt(variance) * deviate - 0.5 * variance);
}

/// A normal variation along the scala.
anatomy::AngularVariation variation(analysis::RandomStream random, double deviation,
                                    Angle correlation)
{
  anatomy::AngularVariation drawn;
  drawn.amplitude = deviation * std::sqrt(2.0 / static_cast<double>(drawn.waves.size()));
  for (auto& [frequency, phase] : drawn.waves) {
    frequency = random.normal() / correlation.si();
    phase = random.between(0.0, 2.0 * pi);
  }
  return drawn;
}

/// Between two limits, uniform in the logarithm.
double logUniform(analysis::RandomStream& random, double low, double high)
{
  return exponential(random.between(logarithm(low), logarithm(high)));
}

/// Draws A, B and H, each conditional on those before it: the Cholesky factor of the correlations of
/// their errors.
void drawMeasures(analysis::RandomStream random, anatomy::BasalTurn& turn,
                  const anatomy::BasalTurnErrors& errors)
{
  const auto deviate = [](Length value, Length from, Length error) {
    return error.si() > 0.0 ? (value - from) / error : 0.0;
  };
  const anatomy::Spread a = anatomy::spreadOfA(), b = anatomy::spreadOfB();
  const anatomy::BasalTurn mean = turn;
  turn.a = drawLength(random, mean.a, errors.a, a.low, a.high);
  const double first = deviate(turn.a, mean.a, errors.a);
  const double restOfB = std::sqrt(1.0 - errors.ab * errors.ab);
  const Length meanOfB = mean.b + errors.ab * first * errors.b;
  turn.b = drawLength(random, meanOfB, restOfB * errors.b, b.low, b.high);
  if (!mean.h) return;
  const double second = deviate(turn.b, meanOfB, restOfB * errors.b);
  const anatomy::Spread h = anatomy::limitsOfH();
  const Length error = errors.h.value_or(analysis::measuringError);
  const double byB = (errors.bh - errors.ab * errors.ah) / restOfB;
  const double rest = std::sqrt(1.0 - errors.ah * errors.ah - byB * byB);
  turn.h = drawLength(random, *mean.h + (errors.ah * first + byB * second) * error, rest * error,
                      h.low, h.high);
}

/// Draws what a cochlea with the drawn measures has of its own.
///
/// @param stream  Gives the random numbers of a purpose.
template <class Stream>
void drawShape(const Stream& stream, const Uncertainty& uncertainty, PlanDraw& drawn)
{
  const anatomy::BasalTurn& turn = *drawn.patient.basalTurn;
  anatomy::IndividualShape& shape = drawn.shape;
  analysis::RandomStream sharing = stream(Draw::shape);
  for (double& deviate : drawn.sharing)
    deviate = sharing.normal(0.0, 1.0, -maxDeviates, maxDeviates);
  shape.half = anatomy::individualHalfDiameters(turn.a, turn.b, drawn.sharing);
  const auto& [section, sectionCorrelation] = uncertainty.section;
  shape.section = factorOf(0.0, section);
  shape.sections = variation(stream(Draw::section), std::sqrt(logarithm(1.0 + section * section)),
                             sectionCorrelation);
  shape.course = variation(stream(Draw::course), uncertainty.course.standardDeviation,
                           uncertainty.course.correlation);
  shape.radius = variation(stream(Draw::radius), uncertainty.radius.standardDeviation,
                           uncertainty.radius.correlation);
  if (turn.h) return;
  analysis::RandomStream height = stream(Draw::height);
  shape.height +=
      uncertainty.heightDeviation *
      height.normal(0.0, 1.0, -uncertainty.maxHeightDeviates, uncertainty.maxHeightDeviates);
}

}  // namespace

PlanDraw drawPlan(const anatomy::Patient& patient, const Uncertainty& uncertainty,
                  const analysis::HandDistribution& hand, std::uint64_t seed, std::uint64_t number,
                  const session::FrictionSpread& friction)
{
  const auto stream = [&](Draw draw) {
    return analysis::RandomStream(seed, number, static_cast<std::uint64_t>(draw));
  };
  PlanDraw drawn;
  drawn.patient = patient;
  drawMeasures(stream(Draw::measures), *drawn.patient.basalTurn, analysis::errorsOf(patient));
  drawShape(stream, uncertainty, drawn);
  analysis::RandomStream tissue = stream(Draw::tissue);
  drawn.lining =
      meters(logUniform(tissue, uncertainty.liningLow.si(), uncertainty.liningHigh.si()));
  drawn.membrane = newtonsPerMeter(
      logUniform(tissue, uncertainty.membraneLow.si(), uncertainty.membraneHigh.si()));

  analysis::RandomStream approach = stream(Draw::approach);
  const auto deviate = [&] {
    return approach.normal(0.0, 1.0, -uncertainty.maxDeviates, uncertainty.maxDeviates);
  };
  drawn.tilt = deviate() * uncertainty.tiltDeviation;
  drawn.turn = deviate() * uncertainty.turnDeviation;
  drawn.stiffnessDeviate = stream(Draw::stiffness).normal(0.0, 1.0, -maxDeviates, maxDeviates);
  drawn.packing = analysis::drawPacking(uncertainty.packing, seed, number);
  drawn.taper = analysis::drawTaper(seed, number);
  drawn.surgeon = analysis::drawSurgeon(hand, seed, number, friction);
  return drawn;
}

double stiffnessFactor(const PlanDraw& draw, double deviation)
{
  return factorOf(draw.stiffnessDeviate, deviation);
}

session::InsertionParameters drawnParameters(const session::InsertionParameters& nominal,
                                             const PlanDraw& draw, double stiffness,
                                             const std::optional<Resolution>& resolution)
{
  session::InsertionParameters parameters = nominal;
  if (resolution) {
    parameters.nodes = resolution->nodes;
    parameters.timeStep = resolution->step;
  }
  parameters.cochlea.patient = draw.patient;
  parameters.wall.lining = draw.lining;
  if (parameters.membrane) parameters.membrane->perSamplePoint = draw.membrane;
  parameters.approachTilt = parameters.approachTilt + draw.tilt;
  parameters.approachTurn = parameters.approachTurn + draw.turn;
  parameters.array = session::calibrated(
      electrode::withTaper(electrode::withWirePacking(nominal.array, draw.packing), draw.taper),
      stiffness, nominal.array.stylet.residualCurvature);
  return parameters;
}

}  // namespace perilymph::planning
