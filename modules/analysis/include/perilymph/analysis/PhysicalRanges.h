// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a result can be: every reader of results refuses values beyond, and no program writes any.

#include <string>

#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::analysis {

/// Ranges in the units of tables. All are far beyond what was measured (choices, high).
namespace physical {
/// Forces on the hand: an array that meets 2 N is jammed (haptics::InsertionEnd), and a hand
/// is pushed or pulled by no more.
inline constexpr Range force_mN{0.0, 2000.0}, signedForce_mN{-2000.0, 2000.0};
/// On the cochlear partition, which an array can meet steeply.
inline constexpr Range partition_mN{0.0, 10'000.0};
/// Three turns; a lead-in lies before 0 degrees.
inline constexpr Range angle_deg{-45.0, 1100.0};
inline constexpr Range depth_mm{-60.0, 60.0}, scalaLength_mm{0.0, 60.0};
inline constexpr Range a_mm{5.0, 13.0}, b_mm{3.5, 11.0}, h_mm{1.0, 8.0};
inline constexpr Range fraction{0.0, 1.0}, percent{0.0, 100.0};
inline constexpr Range frequency_Hz{0.0, 30'000.0};
/// -1 m: no lumen lies toward the modiolus (ContactPosition::toModiolus).
inline constexpr Range toModiolus_mm{-1000.0, 20.0};
inline constexpr Range semitones{-200.0, 200.0};
}  // namespace physical

/// Whether a value, never NaN, is within a range, its ends included.
constexpr bool isWithin(double value, Range range)
{
  return value >= range.low && value <= range.high;
}

/// "the peak force is -5 mN; 0 to 2000 mN is possible"; empty for a value within its range.
std::string impossibility(const char* quantity, const char* unit, double value, Range range);

/// The same for the first value of an insertion that is out of its range.
std::string impossibility(const InsertionRun& insertion);
std::string impossibility(const ClinicalInsertion& insertion);

/// An insertion as it is kept: forces of one that jammed are 2 N at most, which it exceeds by
/// definition; another one with an impossible value was not computed, which is stated.
InsertionRun asPossible(InsertionRun insertion);
ClinicalInsertion asPossible(ClinicalInsertion insertion);

}  // namespace perilymph::analysis
