// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A setting moved at random for many ticks, with books kept of what must never happen.

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>

#include "RandomHand.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::test {

/// One row of the matrix.
struct Setting {
  std::string name;
  std::string anatomy = "mean";  ///< "mean" or "published".
  std::string array = "contour";
  mechanics::FrictionLaw friction;
  mechanics::RelaxationLaw relaxation;
  double yieldMoment = 0.0;  ///< At which wires with half of the stiffness yield [N.m]; 0: elastic.
  double wall = 441.0;       ///< Per sample point [N/m].
  mechanics::Coupling coupling = mechanics::Coupling::rigid;
  StyletUse stylet = StyletUse::stays;
  bool isLined = false;          ///< Bone under a soft lining instead of `wall`.
  bool hasRim = false;           ///< The round window around the array.
  bool hasSoftMembrane = false;  ///< In the roof.
  bool isWatchedLonger = false;  ///< In the quick tier: twenty thousand ticks.
  double timeStep = 1e-3;        ///< [s]
  int nodes = 60;
  HandLimits hand;

  /// For the name of a test.
  friend void PrintTo(const Setting& setting, std::ostream* out) { *out << setting.name; }
};

std::shared_ptr<const mechanics::InsertionModel> build(const Setting& setting);

/// What came of it. Energies in joule, forces in newton, lengths in meter.
struct Findings {
  long ticks = 0;
  long notFinite = 0;              ///< Ticks after which a number had overflowed.
  double deepest = 0.0;            ///< Greatest penetration of a node.
  double unexplained = 0.0;        ///< Greatest penetration beyond what the node's force explains.
  bool startsRelaxed = false;      ///< A straight array.
  double minEnergy = 0.0;          ///< Minimum energy of hand, stylet and start together.
  double minHandEnergy = 0.0;      ///< Minimum energy of the hand alone.
  long notConverged = 0;           ///< Ticks with more than 2 uN left where no contact changed.
  double maxResidualAtRest = 0.0;  ///< The most left in one of them.
  long toggles = 0;                ///< Ticks in which a contact began, ended, or changed between
                                   ///< stick and slip.
  long togglesNotConverged = 0;    ///< Toggles with more than 1 mN left.
  double worstToggle = 0.0;        ///< The most left in one of them.
  long unbalanced = 0;             ///< Ticks of either kind with more than 1 mN left.
  double greatestForce = 0.0;      ///< On the hand.
  int maxEvaluations = 0;          ///< Maximum evaluations of all forces in one tick.
  int maxFactorizations = 0;       ///< Maximum factorizations in one tick.
  long settling = 0;               ///< Ticks that went on in the next one.
  long longestSettling = 0;        ///< The most of them in a row before the array buckles.
  long rests = 0;                  ///< Times that the hand was held still for 50 ms, the
                                   ///< array not buckled.
  long restsUnsettled = 0;         ///< Rests after which a step still went on.
  long restsElsewhere = 0;         ///< Rests that ended more than 1 um or 0.1 mN from where
                                   ///< unlimited work in every tick of the rest takes the array.
  double apartAtRest = 0.0;  ///< Greatest distance of a node from where unlimited work in every
                             ///< tick of the rest takes it.
  double forceApartAtRest = 0.0;  ///< The same for the force on the hand.
  double iterations = 0.0;        ///< Newton iterations, mean of a tick.
};

/// Runs insertions of 20,000 ticks, each from the start and with a hand of its own, until `ticks`
/// are done. Stops at the first number that overflows.
Findings run(const Setting& setting, long ticks, std::uint64_t seed);

/// The findings as one line.
std::string summaryOf(const Findings& findings);

}  // namespace perilymph::test
