// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How surgeons hold and push an array: distributions with sources, and the drawing of one surgeon.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::analysis {

/// The hands of surgeons.
struct HandDistribution {
  /// Source and confidence of the values of one table of the file.
  struct Provenance {
    std::string table, source, confidence;
  };

  Speed speedMean, speedDeviation, speedLow, speedHigh;  ///< Normal within the range.
  Length tremorLow, tremorHigh;                          ///< Root mean square, three axes: uniform.
  double tremorFrequency = 0.0;                          ///< [Hz]
  Length freeLengthLow, freeLengthHigh;                  ///< From the opening to the forceps.
  Force stopLow, stopHigh;                               ///< At which the surgeon stops: uniform.
  /// How deep the surgeon means to push, between 0, the most basal contact just inside, and 1, the
  /// greatest depth: uniform.
  double intendedLow = 0.0, intendedHigh = 1.0;
  Duration rest, restMean;  ///< Rest after the push, and the time over which forces are averaged.
  Length bucklingLag;       ///< Lag of the tip at which a bow is visible.
  /// Fraction of all coefficients where the friction states no spread: log-normal with mean 1.
  double frictionDeviation = 0.0;
  Force ruptureMean, ruptureDeviation, ruptureLow, ruptureHigh;  ///< Normal within the range.
  std::vector<Provenance> provenance;
};

/// Reads the distributions from a TOML file.
Result<HandDistribution> loadHand(const std::filesystem::path& file);
/// The shipped file: resources/clinical/hand.toml.
std::filesystem::path shippedHandFile();
Result<HandDistribution> shippedHand();

/// One surgeon and one cochlear lining.
struct Surgeon {
  Speed speed;
  Length tremor;                        ///< Root mean square of the distance in three axes.
  std::array<double, 3> tremorPhase{};  ///< [rad]
  Length freeLength;
  Force stop;                   ///< Axial force at which this surgeon stops.
  double intended = 1.0;        ///< How deep this surgeon means to push; see intendedDepth().
  double frictionFactor = 1.0;  ///< Common factor of the coefficients of friction.
  double sharedFriction = 0.0;  ///< The part of its logarithm that is common to all ears.
  Force rupture;                ///< Force on the partition at which it ruptures.
};

/// Surgeon `number` of a seed: the same on every machine, in any order.
///
/// @param spread  The friction's, if known: the factor is then log-normal with median 1.
Surgeon drawSurgeon(const HandDistribution& hand, std::uint64_t seed, std::uint64_t number,
                    const session::FrictionSpread& spread = {});

}  // namespace perilymph::analysis
