// SPDX-License-Identifier: BSD-3-Clause

// Repetitions of the experiment with drawn inputs, each fitted to the force at the basal turn.

#include <algorithm>
#include <cmath>

#include "experiment/MeasuredInsertion.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Calibration.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/validation/PriorPredictive.h"
#include "perilymph/validation/ValidationReport.h"
#include "prior/InputDraw.h"

namespace perilymph::validation {

namespace {

constexpr std::uint64_t insertionsPerExperiment = 11;  // derived from the printed intervals
constexpr std::uint64_t fewestComplete = 6;            // choice, high: more than half
// The force is nearly linear in the scale: within this, a line through two scales is off by a
// fiftieth of it.
constexpr double nearForce = 0.004;  // [N]
constexpr int maxScales = 5;
constexpr double smallestChange = 0.03;  // of the scale, for a slope above the noise

// 50 to 1000 nodes differ by 1.7 % of the peak, steps of 0.1 to 10 ms by 0.8 mN, 2 mN at the rib (page of
// mechanics): a tenth of what the inputs make, at a quarter of the time.
constexpr int coarseNodes = 50;
constexpr Duration coarseStep = milliseconds(10);

using Forces = std::array<double, comparedTravels_mm.size()>;

/// Mean forces with one scale of the stiffness.
struct Trial {
  double scale = 0.0;
  Forces force{};
  std::uint64_t complete = 0;
  std::string fault;
};

/// The experiment with one set of inputs.
class Experiment {
public:
  Experiment(const PriorRequest& request, const InputValues& inputs, std::uint64_t number)
      : inputs_(inputs),
        nominal_(withInputs(request.nominal, inputs)),
        variability_(withInputs(request.variability, inputs)),
        seed_(request.seed),
        number_(number)
  {
  }

  Result<void> build()
  {
    auto built = session::buildAnatomy(nominal_);
    if (!built) return built.error();
    anatomy_ = *built;
    return {};
  }

  const electrode::ArrayDesign& array() const { return nominal_.array; }

  Result<Trial> run(double scale, const std::stop_token& stop) const
  {
    session::InsertionParameters scaled = nominal_;
    scaled.array =
        session::calibrated(nominal_.array, scale, nominal_.array.stylet.residualCurvature);
    Trial trial;
    trial.scale = scale;
    for (std::uint64_t i = 0; i < insertionsPerExperiment; ++i) {
      const DrawnInsertion drawn = drawInsertion(scaled, variability_, SpreadSources::all(), seed_,
                                                 number_ * insertionsPerExperiment + i);
      const auto measured = measure(drawn, anatomy_, variability_.samplePeriod,
                                    profileEnd() + millimeters(0.5), stop);
      if (!measured) return measured.error();
      if (measured->incomplete) {
        if (trial.fault.empty()) trial.fault = nameOf(measured->incomplete->end);
        continue;
      }
      const StoppedRecord record = stoppedRecord(
          measured->travel, measured->force, profileEnd(), seconds(valueOf(inputs_, Input::stop)),
          valueOf(inputs_, Input::relaxation), variability_.samplePeriod);
      const auto curve = resampled(record.travel, record.force, variability_.knotSpacing);
      if (!curve) return Error{"A record gave too few samples for its spline."};
      ++trial.complete;
      for (std::size_t k = 0; k < trial.force.size(); ++k)
        trial.force[k] += (*curve)[static_cast<std::size_t>(
            std::lround(comparedTravels_mm[k] / inMillimeters(analysis::profileStep())))];
    }
    for (double& force : trial.force)
      force /= static_cast<double>(std::max<std::uint64_t>(1, trial.complete));
    return trial;
  }

private:
  InputValues inputs_;
  session::InsertionParameters nominal_;
  Variability variability_;
  std::uint64_t seed_, number_;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy_;
};

/// The line through two scales, at the printed force.
void interpolate(const Trial& one, const Trial& two, double wanted, RepeatedExperiment& result)
{
  const double change = two.force[0] - one.force[0];
  const double part = (wanted - two.force[0]) / change;
  result.scale = two.scale + part * (two.scale - one.scale);
  for (std::size_t k = 0; k < two.force.size(); ++k) {
    result.slope[k] = (two.force[k] - one.force[k]) / change;
    result.force[k] = two.force[k] + part * (two.force[k] - one.force[k]);
  }
}

}  // namespace

Result<PriorRequest> shippedPrior()
{
  const auto references = validationReferences();
  if (!references) return references.error();
  auto ranges = shippedRanges();
  if (!ranges) return ranges.error();
  auto variability =
      loadVariability(resource("resources/validation/" + ranges->variability + ".toml"));
  if (!variability) return variability.error();
  // the array of its file: every repetition is fitted anew
  const auto scenario = session::loadScenario(variability->scenario, {{"calibration", ""}});
  if (!scenario) return scenario.error();
  PriorRequest request;
  request.nominal = scenario->parameters();
  request.nominal.nodes = coarseNodes;
  request.variability = *std::move(variability);
  request.variability.timeStep = coarseStep;
  request.experiment = references->experiment;
  request.ranges = *std::move(ranges);
  return request;
}

Result<RepeatedExperiment> repeatExperiment(const PriorRequest& request, std::uint64_t number,
                                            const std::stop_token& stop)
{
  const analysis::PrintedForce* printed = request.experiment.find(fittedFeature);
  if (!printed) return Error{"The reference '%1' has no force to fit.", request.experiment.label};
  RepeatedExperiment result;
  result.number = number;
  result.inputs = drawInputs(request.ranges, request.seed, number);
  Experiment experiment(request, result.inputs, number);
  if (const auto done = experiment.build(); !done) return done.error();
  const session::FittedValue bounds = session::uncalibrated(experiment.array()).stiffnessScale;
  // as stiff in the basal turn as the published array with its stylet
  constexpr double carrier = 0.5e-6, usual = 0.833 * (carrier + 1.21e-6);  // [N m^2]
  const double guess = std::clamp(usual / (carrier + experiment.array().stylet.bending.si()),
                                  bounds.low, bounds.high);

  auto last = experiment.run(guess, stop);
  if (!last) return last.error();
  const auto isLeftOut = [&](const Trial& trial) {
    if (trial.complete >= fewestComplete) return false;
    result.reason = "incomplete: " + trial.fault;
    return true;
  };
  if (isLeftOut(*last)) return result;
  double slope = last->force[0] / last->scale;  // [N] per unit of the scale
  for (int scales = 2; scales <= maxScales; ++scales) {
    double next = last->scale + (printed->mean - last->force[0]) / slope;
    if (next < bounds.low || next > bounds.high) next = std::clamp(next, bounds.low, bounds.high);
    if (std::fabs(next - last->scale) < smallestChange * last->scale)
      next = last->scale * (next < last->scale ? 1.0 - smallestChange : 1.0 + smallestChange);
    const auto now = experiment.run(next, stop);
    if (!now) return now.error();
    if (isLeftOut(*now)) return result;
    interpolate(*last, *now, printed->mean, result);
    const double secant = (now->force[0] - last->force[0]) / (now->scale - last->scale);
    const bool isNear = std::fabs(now->force[0] - printed->mean) <= nearForce ||
                        std::fabs(last->force[0] - printed->mean) <= nearForce;
    if (secant > 0.0 && isNear) {
      if (result.scale < bounds.low || result.scale > bounds.high)
        result.reason = "stiffness beyond its bounds";
      return result;
    }
    const bool isHeld = (next <= bounds.low && now->force[0] > printed->mean) ||
                        (next >= bounds.high && now->force[0] < printed->mean);
    if (isHeld) {
      result.reason = "stiffness beyond its bounds";
      return result;
    }
    if (secant > 0.0) slope = secant;
    *last = *now;
  }
  result.reason = "no fit";
  return result;
}

Result<std::vector<RepeatedExperiment>> repeatExperiments(const PriorRequest& request,
                                                          const analysis::RunProgress& progress,
                                                          const std::stop_token& stop)
{
  const auto wanted = static_cast<std::size_t>(request.draws);
  std::vector<RepeatedExperiment> all;
  std::size_t counted = 0;
  while (counted < wanted && all.size() < drawsPerRepetition * wanted) {
    // as many as are missing, so that neither order nor threads affect which are run
    const std::size_t first = all.size();
    const std::size_t more = std::min(wanted - counted, drawsPerRepetition * wanted - first);
    all.resize(first + more);
    const auto work = [&](std::size_t piece, const std::stop_token& ending) -> Result<void> {
      auto one = repeatExperiment(request, first + piece + 1, ending);
      if (!one) return one.error();
      all[first + piece] = *std::move(one);
      return {};
    };
    const auto done = doInParallel(
        more, request.jobs, work,
        [&](std::size_t count) {
          if (progress) progress(std::min(wanted, counted + count), wanted);
        },
        stop);
    if (!done) return done.error();
    counted = static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(),
                      [](const RepeatedExperiment& each) { return each.reason.empty(); }));
  }
  return all;
}

}  // namespace perilymph::validation
