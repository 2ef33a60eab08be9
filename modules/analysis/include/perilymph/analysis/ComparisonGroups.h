// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Groups of compared insertions: means with standard deviations, and differences with intervals.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/analysis/Comparison.h"
#include "perilymph/analysis/Reference.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/Sentence.h"

namespace perilymph::analysis {

/// What insertions of one group have in common.
enum class GroupKey : std::uint8_t { array, technique, patient, friction, speed };

/// Insertions with equal values of some keys.
struct InsertionGroup {
  /// One for each key, as in the subjects; "0.165 (soap-50)" of a friction, "2 mm/s" or "by hand" of a speed.
  std::vector<std::string> values;
  std::vector<std::size_t> members;  ///< Indices of the insertions, ascending.

  /// The values, joined by " · ".
  std::string name() const;
  /// The same with techniques in words, for display: "FLEX28 · advance off-stylet".
  std::string title() const;
};

/// What differs within a group and is none of its keys: friction, set speed, approach, stop, cochlea, array,
/// technique, ending. Its insertions are then not repetitions of one.
std::vector<Phrase> differingIn(const std::vector<ComparedInsertion>& insertions,
                                const InsertionGroup& group);

/// The groups in the order of their names. Without keys there are none.
std::vector<InsertionGroup> groupsOf(const std::vector<ComparedInsertion>& insertions,
                                     const std::vector<GroupKey>& keys);

/// A quantity whose means are compared.
struct ComparedQuantity {
  const char* key;   ///< Its column in comparisonCsv(), with its unit.
  Phrase name;       ///< For display.
  const char* unit;  ///< For display: "mN".
  double factor;     ///< From the unit of the column to that of the display.
  int decimals;      ///< In the unit of the display.
  /// In the unit of the column; empty if the insertion has none.
  std::optional<double> (*of)(const ComparedInsertion&);
};
const std::vector<ComparedQuantity>& comparedQuantities();

/// The values of the members that have one, in the unit of the column.
std::vector<double> valuesOf(const std::vector<ComparedInsertion>& insertions,
                             const InsertionGroup& group, const ComparedQuantity& quantity);

/// `group, quantity, n, mean, sd, low95, high95`: a row for each group and quantity. The interval of the
/// mean is Student's; sd and interval are empty for fewer than two insertions.
std::string groupsCsv(const std::vector<ComparedInsertion>& insertions,
                      const std::vector<InsertionGroup>& groups);

/// `group, other, quantity, n, n_other, difference, low95, high95, degrees_of_freedom`: group minus other
/// for each pair, by welchDifference(); the last three are empty where it is.
std::string differencesCsv(const std::vector<ComparedInsertion>& insertions,
                           const std::vector<InsertionGroup>& groups);

/// Mean force of a group over an axis, at multiples of stepOf().
struct MeanCurve {
  std::vector<double> place;       ///< [m] or [rad]
  std::vector<double> mean, sd;    ///< [N]; sd is 0 for one insertion.
  std::vector<std::size_t> count;  ///< Insertions with a force there.
};
/// Goes as far as half of the insertions do, so that it is not the curve of a few.
MeanCurve meanCurve(const std::vector<ComparedInsertion>& insertions, const InsertionGroup& group,
                    CurveAxis axis);

/// The curves over a common axis; with groups their means and standard deviations. Published values
/// are drawn over travel.
figures::Figure comparisonFigure(const std::vector<ComparedInsertion>& insertions,
                                 const Reference* published = nullptr,
                                 CurveAxis axis = CurveAxis::travel,
                                 const std::vector<InsertionGroup>& groups = {});

/// Place of a maximum on an axis [m or rad].
double placeOf(const ForceAtDepth& maximum, CurveAxis axis);

}  // namespace perilymph::analysis
