// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One insertion by a drawn surgeon, in virtual time.

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/analysis/Surgeon.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::analysis {

/// One insertion by hand. It counts however it ended.
struct ClinicalInsertion {
  std::string array;
  std::uint64_t seed = 0, patient = 0;
  double sharedFriction = 0.0;  ///< Surgeon::sharedFriction.
  haptics::InsertionEnd end = haptics::InsertionEnd::refused;
  std::string reason;  ///< A message if the engine stopped or refused it.
  Length depth;        ///< At the end, past the opening.
  Angle apical;        ///< Angle of the most apical contact from the round window.
  Force peak;          ///< Maximum axial force on the hand.
  Force endForce;      ///< StopForce over HandDistribution::restMean.
  /// Mean force over the last HandDistribution::restMean of 1 s and of 10 s of rest; absent if it did not rest so long, and from
  /// files of versions whose endForce was that after 2 s.
  std::optional<Force> forceAfter1s, forceAfter10s;
  Force partition;              ///< Maximum force on the cochlear partition, within one contact.
  bool isRuptured = false;      ///< The partition ruptured, at its drawn strength.
  bool isTranslocated = false;  ///< A part of the array is above the partition at the end.
  Angle ruptureAngle;           ///< Place of the first rupture; 0 without one.
  std::vector<ContactPosition> contacts;  ///< At the end, from the tip.
  std::vector<DepthForce> profile;        ///< Force at multiples of a spacing, first passage.
};

/// Depth of the tip past the opening to which a surgeon means to push an array: between the depth at
/// which its most basal contact is just inside and the greatest of the parameters, their fraction
/// Surgeon::intended; the greatest for an array without contacts.
Length intendedDepth(const session::InsertionParameters& nominal, const Surgeon& surgeon);

/// Pushes an array until it is as deep as the surgeon means, or its force reaches the surgeon's limit,
/// or the array buckles or slips out; then the hand rests, still trembling, while the force relaxes.
///
/// @param nominal         The scenario's; the surgeon replaces speed, friction and free length.
/// @param profileSpacing  Between points of the force profile; 0: no profile.
/// @param stop            Ends it early; the result is then meaningless.
/// @param shape           Receives the array at the end, for a view; may be null.
ClinicalInsertion insertByHand(const session::InsertionParameters& nominal,
                               std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                               const HandDistribution& hand, const Surgeon& surgeon,
                               Length profileSpacing, const std::stop_token& stop,
                               haptics::Snapshot* shape = nullptr);

}  // namespace perilymph::analysis
