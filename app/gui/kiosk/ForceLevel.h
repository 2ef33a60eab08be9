// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force on the hand in three levels, for visitors who know no millinewtons.

#include <QColor>
#include <QString>

#include "perilymph/analysis/Reference.h"

namespace perilymph::gui {

/// A force against the peak forces that were measured in patients. A comparison, not a statement on
/// safety.
enum class ForceLevel {
  gentle,  ///< Below all of them.
  firm,    ///< Among them.
  tooMuch  ///< Above all of them.
};

ForceLevel levelOf(double force_N, const analysis::PrintedRange& measured);

/// The level in a word: "gentle".
QString wordOf(ForceLevel level);
/// Its sign, which is told from others without colors: a circle, a triangle, a square.
QString signOf(ForceLevel level);
/// Its color in the window's scheme.
QColor colorOf(ForceLevel level);
/// The comparison as a sentence: "Gentle: below the forces measured in patients."
QString sentenceOf(ForceLevel level);

/// The range that levels compare with, and its source.
QString levelSource(const analysis::PrintedRange& measured);

}  // namespace perilymph::gui
