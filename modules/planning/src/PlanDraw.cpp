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
enum class Draw : std::uint64_t { measures = 200, approach, stiffness };

/// Deviates beyond which a measure or a stiffness is not drawn (choice, high).
constexpr double maxDeviates = 3.0;

Length drawLength(analysis::RandomStream& random, Length mean, Length deviation, Length low,
                  Length high)
{
  return meters(random.normal(mean.si(), deviation.si(), low.si(), high.si()));
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
  const double variance = logarithm(1.0 + deviation * deviation);
  return exponential(std::sqrt(variance) * draw.stiffnessDeviate - 0.5 * variance);
}

session::InsertionParameters drawnParameters(const session::InsertionParameters& nominal,
                                             const PlanDraw& draw, double stiffness)
{
  session::InsertionParameters parameters = nominal;
  parameters.cochlea.patient = draw.patient;
  parameters.approachTilt = parameters.approachTilt + draw.tilt;
  parameters.approachTurn = parameters.approachTurn + draw.turn;
  parameters.array =
      session::calibrated(nominal.array, stiffness, nominal.array.stylet.residualCurvature);
  return parameters;
}

}  // namespace perilymph::planning
