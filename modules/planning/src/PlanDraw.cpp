// SPDX-License-Identifier: BSD-3-Clause
#include "PlanDraw.h"

#include <cmath>

#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/analysis/RandomStream.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/session/Calibration.h"

namespace perilymph::planning {

namespace {

/// Uses of random numbers, apart from those of analysis::drawSurgeon().
enum class Draw : std::uint64_t { measures = 200, approach, stiffness, shape, tissue };

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

/// Between two limits, uniform in the logarithm.
double logUniform(analysis::RandomStream& random, double low, double high)
{
  return exponential(random.between(logarithm(low), logarithm(high)));
}

}  // namespace

PlanDraw drawPlan(const anatomy::Patient& patient, const Uncertainty& uncertainty,
                  const analysis::HandDistribution& hand, std::uint64_t seed, std::uint64_t number)
{
  const auto stream = [&](Draw draw) {
    return analysis::RandomStream(seed, number, static_cast<std::uint64_t>(draw));
  };
  PlanDraw drawn;
  drawn.patient = patient;
  anatomy::BasalTurn& turn = *drawn.patient.basalTurn;
  const anatomy::BasalTurnErrors errors = analysis::errorsOf(patient);
  const anatomy::Spread a = anatomy::spreadOfA(), b = anatomy::spreadOfB();
  analysis::RandomStream measures = stream(Draw::measures);
  turn.a = drawLength(measures, turn.a, errors.a, a.low, a.high);
  turn.b = drawLength(measures, turn.b, errors.b, b.low, b.high);
  if (turn.h) {
    const anatomy::Spread h = anatomy::limitsOfH();
    turn.h =
        drawLength(measures, *turn.h, errors.h.value_or(analysis::measuringError), h.low, h.high);
  }

  analysis::RandomStream shape = stream(Draw::shape);
  for (double& deviate : drawn.sharing) deviate = shape.normal(0.0, 1.0, -maxDeviates, maxDeviates);
  drawn.shape.half = anatomy::individualHalfDiameters(turn.a, turn.b, drawn.sharing);
  drawn.shape.section = factorOf(
      shape.normal(0.0, 1.0, -uncertainty.maxSectionDeviates, uncertainty.maxSectionDeviates),
      uncertainty.sectionDeviation);
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
  drawn.surgeon = analysis::drawSurgeon(hand, seed, number);
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
  parameters.array =
      session::calibrated(nominal.array, stiffness, nominal.array.stylet.residualCurvature);
  return parameters;
}

}  // namespace perilymph::planning
