// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Prior-predictive test of the published experiment: the experiment is repeated many times with inputs
// drawn from the ranges that were declared for them, each time with its stiffness fitted to the force at
// the basal turn, and the other printed forces are compared with what comes out. Procedure: guide,
// constants.md.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/Reference.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/InsertionParameters.h"
#include "perilymph/validation/Variability.h"

namespace perilymph::validation {

/// The uncertain inputs, in the order of a Study's values.
enum class Input : std::size_t {
  startLow,
  startHigh,
  wall,
  edges,
  modulus,
  width,
  passageDiameter,
  straight,
  edgeRadius,
  firstRib,
  secondRib,
  ribHeight,
  ribLength,
  stylet,
  styletEnd,
  exitLoss,
  stop,
  relaxation,
  knots,
};
inline constexpr std::size_t inputCount = 19;
/// Names of the columns, with their units.
extern const std::array<const char*, inputCount> inputNames;

/// The range of one input.
struct InputRange {
  double low = 0.0, high = 0.0;  ///< In the unit of its name.
  bool isLogarithmic = false;    ///< Uniform in the logarithm.
  std::string declared, source;
};

struct DeclaredRanges {
  std::string label, variability;
  std::array<InputRange, inputCount> inputs;
};

/// Reads the ranges from a TOML file.
Result<DeclaredRanges> loadRanges(const std::filesystem::path& file);
/// The shipped ones: resources/prior-predictive/declared-ranges.toml.
Result<DeclaredRanges> shippedRanges();

using InputValues = std::array<double, inputCount>;

/// The inputs of one repetition: the same on every machine, in any order.
InputValues drawInputs(const DeclaredRanges& ranges, std::uint64_t seed, std::uint64_t number);

/// Travels that are compared: the fitted one, then five predicted ones [mm].
inline constexpr std::array<double, 6> comparedTravels_mm = {10.6, 11.8, 12.6, 14.6, 15.4, 16.5};
inline constexpr std::size_t predictedForces = comparedTravels_mm.size() - 1;

/// One repetition of the experiment.
struct RepeatedExperiment {
  std::uint64_t number = 0;  ///< Number of the draw, from 1.
  InputValues inputs{};
  double scale = 0.0;                                     ///< Fitted factor of the stiffness.
  std::array<double, comparedTravels_mm.size()> force{};  ///< Means of its insertions [N].
  /// Change of each force with that at the fitted travel.
  std::array<double, comparedTravels_mm.size()> slope{};
  std::string reason;  ///< Why it is left out; empty if it counts.
};

struct PriorRequest {
  session::InsertionParameters nominal;  ///< The published insertion, with the array of its file.
  Variability variability;
  analysis::Reference experiment;
  DeclaredRanges ranges;
  int draws = 400;  ///< Repetitions that count; at least 20.
  std::uint64_t seed = 1;
  unsigned jobs = 0;
};

/// The shipped experiment with its ranges.
Result<PriorRequest> shippedPrior();

/// Repetitions at most for each that counts.
inline constexpr int drawsPerRepetition = 3;

/// One repetition, fitted.
Result<RepeatedExperiment> repeatExperiment(const PriorRequest& request, std::uint64_t number,
                                            const std::stop_token& stop = {});

/// Repetitions in order until `draws` of them count. The same request gives the same bits for any
/// `jobs`. `stop` ends the work early, with an error.
Result<std::vector<RepeatedExperiment>> repeatExperiments(
    const PriorRequest& request, const analysis::RunProgress& progress = {},
    const std::stop_token& stop = {});

/// A printed force beside the predictions.
struct PredictedAnchor {
  double travel_mm = 0.0;
  double low = 0.0, high = 0.0;        ///< Experiment's mean, or the interval that holds it [N].
  double standardError = 0.0;          ///< Standard error of the experiment's mean [N].
  double mean = 0.0, deviation = 0.0;  ///< Predicted [N].
  double low90 = 0.0, high90 = 0.0;    ///< Predicted [N].
  /// The same with the experiment's error and that of the fitted force, independent.
  double low90WithError = 0.0, high90WithError = 0.0;
  double rank = 0.0;           ///< Fraction of the predictions below the experiment.
  double rankWithError = 0.0;  ///< The same with the errors, independent.
  bool isInside = false;       ///< Within the 90 % of predictions with errors.
  /// Spearman's rank correlation with each input.
  std::array<double, inputCount> correlation{};
};

/// The five forces together, for one correlation of the experiment's errors.
struct JointTest {
  double correlation = 0.0;
  double distance = 0.0;  ///< Squared Mahalanobis distance.
  double pValue = 0.0;    ///< Tail of a chi-square of five.
  double counted = 0.0;   ///< Fraction of the repetitions, with errors drawn, that are farther.
};

struct PriorSummary {
  int counted = 0;
  int leftOut = 0;  ///< Draws without a fit, or whose insertions do not reach the end.
  std::vector<PredictedAnchor> anchors;
  std::vector<JointTest> joint;  ///< Errors independent, and correlated by 0.7.
};

/// Compares repetitions that count with the experiment; needs at least 20.
Result<PriorSummary> summarize(const std::vector<RepeatedExperiment>& repetitions,
                               const analysis::Reference& experiment);

/// `draw, reason, inputs ..., scale, force_10.6_mN, ..., slope_11.8, ...`.
std::string priorCsv(const std::vector<RepeatedExperiment>& repetitions);
/// `travel_mm, experiment_low_mN, ...`, one row per force, and the joint tests behind.
std::string priorSummaryCsv(const PriorSummary& summary);
/// All numbers, with the ranges and their sources.
std::string priorJson(const PriorRequest& request, const PriorSummary& summary);

}  // namespace perilymph::validation
