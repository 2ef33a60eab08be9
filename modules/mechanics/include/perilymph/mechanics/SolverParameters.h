// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The numbers that decide how exactly the rod's equilibrium is solved, and with how much work.

namespace perilymph::mechanics {

/// Tolerances and bounds of one time step of a rod. A step takes Newton iterations; each solves the
/// linear system for a motion d of the nodes, moves them along it as far as a line search allows, and
/// evaluates all forces once per try.
///
/// All are choices of the project (confidence low) and no part of a scenario. What they achieve is
/// measured by the random motions of test/physics/robust. A model's fingerprint includes them if they
/// differ from these defaults.
struct SolverParameters {
  // --- The work of a step. It is counted, because bits may not depend on a clock. ---

  /// Maximum evaluations of all forces, so that a tick ends in time (guide, `performance.md`).
  int maxEvaluations = 32;
  /// Maximum factorizations of the stiffness, for the same reason.
  int maxFactorizations = 10;
  /// Maximum evaluations along one d.
  int maxTries = 6;

  // --- When a step is solved ---

  /// Largest unbalanced force on any node, and of the sum over all nodes, in equilibrium [N]: a
  /// ten-thousandth of the forces of an insertion (20 to 100 mN).
  double forceTolerance = 2e-6;
  /// Largest remaining motion |d| of a node at rest [m]: small forces alone do not suffice, because a
  /// rod bends under very little.
  double motionTolerance = 0.2e-9;
  /// The same as a fraction of the motion of the base in the step: 10 nm at 2 mm/s. The prediction of
  /// the next step makes what remains.
  double motionFraction = 5e-3;
  /// Force below which nothing moves, so that no iteration begins [N].
  double atRest = 1e-9;
  /// Motion below which an iteration has no effect, as where a contact toggles [m].
  double stuck = 1e-9;
  /// Such an iteration must reduce the sum of squared forces below this fraction to be continued.
  double minGain = 0.9;
  /// A step that ends with a larger force is continued in the next one, without momentum [N]: so that
  /// an array that snaps does so over some ticks of bounded work.
  double settledForce = 0.1e-3;

  // --- How far an iteration goes ---

  /// Maximum motion of one node in one iteration [m]: about a diameter of the array, so that a node
  /// does not jump over a wall.
  double longestStep = 0.5e-3;
  /// An iteration is too long if the opposing slope of the energy at its end exceeds this fraction of
  /// the slope at its start.
  double slopeTolerance = 0.3;

  // --- When factors of the stiffness and sections are renewed ---

  /// Factors of an earlier step are good for iterations shorter than this [m].
  double farStep = 50e-6;
  /// Oval sections are evaluated again after a first iteration that is longer than this [m].
  double nearStep = 20e-6;
  /// An iteration with good factors reduces the unbalanced forces below this fraction ...
  double goodRatio = 0.1;
  /// ... and leaves one that is shorter by this factor (measured: by 19 in the median, by 4.4 or more
  /// in 90 of 100).
  double goodReduction = 5.0;
  /// Factors are renewed after an iteration that leaves more than this fraction of the unbalanced
  /// forces. Up to 0.25 the iterations that it adds cost less than the factorizations that it saves
  /// (measured in insertions of 1 and 5 ms steps, and under a random hand).
  double keptRatio = 0.2;

  // --- Friction and prediction ---

  /// Friction is bounded by an expected normal force, which is renewed while its error may exceed
  /// this [N].
  double maxLag = 0.1e-3;
  /// Maximum renewals in a step.
  int maxPasses = 2;
  /// A step that takes more iterations than this keeps the normal force at its start.
  int maxIterationsToRenew = 6;
  /// Fraction of the error of a prediction by which the trend of the velocities is corrected. From 0.2
  /// to 0.5 steps take as many evaluations.
  double trendGain = 0.3;

  bool operator==(const SolverParameters&) const = default;
};

}  // namespace perilymph::mechanics
