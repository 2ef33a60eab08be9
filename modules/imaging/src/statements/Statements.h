// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The rule for quantities that a file or series states in two places: both statements must agree.

#include <optional>

#include "perilymph/foundation/Sentence.h"

namespace perilymph::imaging {

/// What a reader does where two statements differ.
enum class Disagreement { refuse, warn };

/// A quantity, the two places that state it, and how far they may differ: by `relative` of the
/// larger one or by `absolute`, whichever is more. Two texts agree where they are the same.
struct StatedTwice {
  const char* format;         ///< The file's format: "NIfTI", "DICOM", ...
  const char* quantity;       ///< With its article: "the voxel size along k".
  const char* first;          ///< The place that is used: "the SForm".
  const char* second;         ///< "pixdim[3]".
  const char* unit;           ///< "mm"; empty for counts and texts.
  double relative, absolute;  ///< The latter in that unit.
  Disagreement answer;
  const char* remedy;  ///< What to do, as an order without a period.
};

/// A pair whose disagreement is refused, with the usual remedy.
constexpr StatedTwice refusedPair(const char* format, const char* quantity, const char* first,
                                  const char* second, const char* unit, double relative,
                                  double absolute = 0.0,
                                  const char* remedy = "export it again from the original series")
{
  return {format, quantity, first, second, unit, relative, absolute, Disagreement::refuse, remedy};
}

/// The sentence about a disagreement, for an Error or a warning; empty where both agree:
///
///     <subject> states <quantity> twice: <first> in <place> and <second> in <place>; <remedy>.
///
/// A value that is no finite number agrees with nothing.
///
/// @param subject  What states it: the file's path, "The series".
/// @param which    Behind the quantity: " along k", " of slice 12"; may be empty.
std::optional<Sentence> disagreement(const Sentence& subject, const StatedTwice& pair, double first,
                                     double second, const Sentence& which = {});

/// The same for two texts: codes, names, identities.
std::optional<Sentence> disagreement(const Sentence& subject, const StatedTwice& pair,
                                     const Sentence& first, const Sentence& second,
                                     const Sentence& which = {});

/// A row of the table of pairs as the guide prints it, in Markdown.
std::string rowOf(const StatedTwice& pair);

}  // namespace perilymph::imaging
