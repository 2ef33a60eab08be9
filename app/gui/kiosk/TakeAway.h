// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What visitors take away on their phones: an insertion in plain text.

#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include "gui/kiosk/ForceLevel.h"
#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

/// A completed insertion of a visitor, without anything personal.
struct TakeAway {
  QString array;                    ///< Name of the electrode array.
  Length depth;                     ///< Insertion depth that was reached.
  Force peak;                       ///< Largest force of any tick, as the engine found it.
  std::optional<ForceLevel> level;  ///< Level of the peak.
  int rank = 0;                     ///< Today, from 1.
  int insertions = 0;               ///< Completed today.
  std::vector<std::pair<Length, Force>> curve;  ///< Force over insertion depth.
};

/// Points of the curve: as many as a QR code of some 70 modules holds beside the numbers.
inline constexpr int takeAwayPoints = 20;

/// The force at equally spaced depths, from one step past the start to the maximum depth, linearly
/// interpolated where the curve first passes them.
///
/// @param curve        Force over travel, as ForceProfile has it.
/// @param startInside  Insertion depth at travel 0.
std::vector<std::pair<Length, Force>> takeAwayCurve(const std::vector<analysis::CurvePoint>& curve,
                                                    Length startInside);

/// The text, line by line, with one point of the curve on each of its last lines: "17.0: 28".
QString takeAwayText(const TakeAway& taken);

}  // namespace perilymph::gui
