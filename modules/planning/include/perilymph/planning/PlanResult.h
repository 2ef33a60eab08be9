// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The insertions of a plan and what they give for each array.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/foundation/Seal.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/planning/PlanRequest.h"

namespace perilymph::planning {

/// Distance between the depths of a force band.
inline constexpr Length bandSpacing = millimeters(0.5);

/// One array in one draw.
struct PlannedInsertion {
  std::size_t draw = 0;                       ///< From 1.
  std::size_t array = 0;                      ///< Index into PlanRequest::arrays.
  double a_mm = 0.0, b_mm = 0.0, h_mm = 0.0;  ///< As drawn; H 0 if the patient has none.
  /// How A and B are shared between both sides of the axis: deviates of the population.
  double a1_deviate = 0.0, b1_deviate = 0.0;
  /// Factor of the sections' width and height at the base (90 degrees) and in the second turn (450).
  double section = 1.0, sectionSecond = 1.0;
  /// Height of the center line at 90 degrees above the middle of its heights at 0 and 180, beyond the
  /// mean course: the dip or peak of the basal turn.
  double dip_mm = 0.0;
  double radius = 1.0;  ///< Factor of the outer wall's distance from the axis at 180 degrees.
  double height = 1.0;  ///< Factor of the mean shape's H; 1 if it was measured.
  double lining_mm = 0.0, membrane_N_m = 0.0;
  double tilt_deg = 0.0, turn_deg = 0.0;  ///< From the scenario's approach.
  double stiffness = 1.0;                 ///< Factor of the array's.
  double packing = 0.0;                   ///< c of the array's wires; 0 if it was not drawn.
  /// The array's width at its most basal contact; 0 if its taper was not drawn.
  double lastContact_mm = 0.0;
  double friction = 1.0;  ///< Factor of the scenario's.
  double speed_mm_s = 0.0;
  double stop_mN = 0.0;  ///< Force at which the surgeon stops.
  double intended_mm =
      0.0;               ///< Depth at which the surgeon means to stop; 0 in plans that drew none.
  double free_mm = 0.0;  ///< From the opening to the forceps; 0 in plans that did not keep it.
  /// In a plan with a clinic's resistance: depth at which the push without a stop ended, whether the array
  /// was in fully, and the depth at each shift of the surgeon's limit (StopDraw); infinite: not reached.
  double push_mm = 0.0;
  bool isPushedFully = true;
  std::vector<double> stop_mm = {};
  /// Nodes of the array at the end, from the base to the tip, in W [m]; empty for an insertion that was
  /// read from a file.
  std::vector<std::array<float, 3>> end_W = {};
  analysis::ClinicalInsertion insertion;
};

/// Quantiles of a quantity over the draws.
struct Band {
  double low = 0.0, lowerQuartile = 0.0, median = 0.0, upperQuartile = 0.0, high = 0.0;
};
/// Force at a depth over the draws whose tip came that deep.
struct ForceBand {
  double depth_mm = 0.0;
  std::size_t draws = 0;
  Band force_mN;
};

/// One contact over the draws in which it is inserted.
struct ContactBand {
  int number = 0;  ///< 1 at the tip.
  std::size_t draws = 0;
  Band angle_deg, toModiolus_mm;
  double greenwood_Hz = 0.0;       ///< At the median of its place along the organ of Corti.
  double spiralGanglion_Hz = 0.0;  ///< At the median of its angle.
  double filter_Hz = 0.0;          ///< Center of its default filter; 0 if no allocation is known.
  /// Frequency of its place on the spiral ganglion above its filter's center; positive: it receives
  /// a lower frequency than its place. Zeros without a filter.
  Band mismatch_semitones;
  /// From 5 to 95 % of greenwood_Hz; both 0 in plans of former versions.
  double greenwoodLow_Hz = 0.0, greenwoodHigh_Hz = 0.0;
};

/// How much of an outcome's variance an input explains: squared rank correlation (Spearman 1904),
/// adjusted for what chance gives it in as many draws, 1 - (1 - r^2) (n - 1) / (n - 2) or 0. Inputs
/// are independent; were one known, the outcome's deviation and band would be sqrt(1 - r^2) as wide. Values
/// that add to more than 1 by chance are reduced in proportion; none of fewer than fewestForBand insertions.
struct Influence {
  std::string input;
  double onAngle = 0.0, onPeak = 0.0;
  double angleWidth_deg = 0.0, peakWidth_mN = 0.0;  ///< From 5 to 95 %, if the input were known.
  /// The angle's width if A, B or H, whichever this is, were measured to `finerError`; 0 for other
  /// inputs and for a measure that is as exact already.
  double finerAngleWidth_deg = 0.0;
};
/// Standard deviation of a finer measurement of A, B or H: an isotropic voxel of 0.2 mm halved
/// (choice, medium).
inline constexpr Length finerError = millimeters(0.1);

/// Bands of an array at the median of its drawn friction, from the same insertions: each value x becomes
/// x - b u, with u the logarithm of the factor of the friction and b the slope of x on u (least
/// squares), and is not below 0. None of fewer than fewestForBand insertions, where chance can make it
/// wider than the total band.
struct AtMedianFriction {
  Band angle_deg, depth_mm, peak_mN, end_mN;
};

/// Two arrays in the same cochleae, with the same hands and frictions: what a difference rests on is
/// what only one of them feels.
struct ArrayDifference {
  std::size_t first = 0, second = 0;  ///< Indices into Plan::arrays.
  std::size_t draws = 0;              ///< In which both could be prepared.
  Band angle_deg, depth_mm, peak_mN;  ///< First minus second.
  analysis::Estimate deeper;          ///< Probability that the first has the larger angle.
  analysis::Estimate harder;          ///< Probability that the first has the larger peak force.
};

/// Depth with a clinic's resistance, which moves neither forces nor ruptures.
struct InClinic {
  Band depth_mm;           ///< Depth of the tip past the opening, before the hand rests.
  double effective = 0.0;  ///< Effective number of simulations; a band needs fewestEffective.
};

/// The clinic's resistance that a plan was asked to use.
struct ClinicSource {
  std::string number;                                         ///< SHA-256 of its file.
  std::size_t resisted = 0, censored = 0, uninformative = 0;  ///< Outcomes by what they told.
  int firstYear = 0, lastYear = 0;
};

/// One array over all draws.
struct ArrayPlan {
  std::string array;  ///< As in the request.
  std::string name;   ///< "FLEX28".
  std::size_t draws = 0;
  Band angle_deg;         ///< Angle of the most apical contact.
  Band coverage_percent;  ///< Organ of Corti basal to it.
  Band depth_mm;          ///< Depth of the tip past the opening.
  Band peak_mN, end_mN;   ///< Axial, on the hand; at the end of the push.
  /// At the median of the friction; absent where the friction states no spread, and in older plans.
  std::optional<AtMedianFriction> atMedianFriction;
  /// End force after 1 s and 10 s of rest; zeros if it was not computed.
  Band after1s_mN, after10s_mN;
  /// Absent without a clinic's resistance, and with too few effective simulations.
  std::optional<InClinic> inClinic;
  Band partition_mN;        ///< Maximum force on the cochlear partition.
  analysis::Estimate full;  ///< That the intended depth is reached, with its 95 % interval.
  /// That all contacts end inside: a complete insertion as clinics count it, whether or not the surgeon meant
  /// to push further. NaN in a plan.json that does not state it.
  analysis::Estimate allInside;
  analysis::Estimate resisted;   ///< That the surgeon stops by resistance.
  analysis::Estimate buckled;    ///< That the array bows in front of the opening.
  analysis::Estimate foldedTip;  ///< That the tip folds over.
  analysis::Estimate other;      ///< That it ends otherwise: out of the opening, jammed, refused.
  analysis::Estimate ruptured;   ///< That the partition ruptures, at its drawn strength.
  analysis::Estimate translocated;  ///< That a part of the array ends in the scala vestibuli.
  /// That the force on the partition reaches the weakest, and the strongest published partition's
  /// strength (Thresholds).
  analysis::Estimate reachesWeakest, reachesStrongest;
  /// Depth at which the axial force first reaches Thresholds::felt, over the draws in which it does.
  Band firstResistance_mm;
  analysis::Estimate felt;       ///< That it does.
  std::vector<ForceBand> force;  ///< At multiples of `bandSpacing`.
  std::vector<ContactBand> contacts;
  std::vector<Influence> influences;  ///< The largest on the angle first.
};

/// Input of a summary about an array before it is inserted.
struct PlannedArray {
  std::string name;               ///< "FLEX28".
  std::vector<double> filter_Hz;  ///< Centers of the default filters from the tip, if known.
};

/// Forces that results are compared with.
struct Thresholds {
  Force felt;                     ///< First resistance: the median force that surgeons detect.
  Force ruptureLow, ruptureHigh;  ///< Published range of the strength of the cochlear partition.
};

/// A plan.
struct Plan {
  PlanRequest request;
  Thresholds thresholds;
  /// Lowest and highest coefficient of the friction that every insertion has, but for its drawn
  /// factor; without bounds if the plan.json does not state it.
  Range friction;
  /// Standard deviation of the logarithm of that factor, where the friction states one. Without, 0, the
  /// factor is that of resources/clinical/hand.toml, and bands are those at one friction.
  double frictionSpread = 0.0;
  std::optional<ClinicSource>
      clinic;  ///< Present if the plan was asked to use a clinic's resistance.
  /// Its number: SHA-256 of everything it depends on but `draws` and `jobs`. Empty for a plan that
  /// was changed after the program wrote it.
  std::string fingerprint;
  Seal seal = Seal::intact;                  ///< State of the file that it was read from.
  std::vector<PlannedInsertion> insertions;  ///< By draw, then by array.
  std::vector<ArrayPlan> arrays;
  /// One for every two arrays; none in older plans.
  std::vector<ArrayDifference> differences;
  /// Whether everything it depends on is still as it was. Otherwise it is shown as it was made, but
  /// not continued and no draw of it is run again.
  bool isCurrent = true;
};

}  // namespace perilymph::planning
