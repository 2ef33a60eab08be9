// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How charts show that a force over depth is of fewer and fewer simulations: the same in all.

#include <cstddef>
#include <string>
#include <vector>

#include "perilymph/figures/Figure.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::planning {

/// The force bands of an array in parts that charts draw apart.
struct ForceCourse {
  /// A place on the median curve.
  struct Mark {
    double depth_mm = 0.0, force_mN = 0.0;
    std::size_t draws = 0;  ///< That came this deep.
  };
  /// Rows of ArrayPlan::force up to the last that every simulation reached. A chart draws the rows
  /// behind it paler and dashed.
  std::size_t whole = 0;
  std::vector<Mark> ends;  ///< Where simulations ended.
  /// Those ends behind which at most three quarters, half and a quarter of the simulations continue, and
  /// the deepest: where a chart writes "n of N".
  std::vector<Mark> counts;
};
ForceCourse courseOf(const ArrayPlan& plan);

/// Entries of a legend; none for an empty one. `count` is "%1 of %2" in the language of the figure.
struct ForceLabels {
  std::string median, wide, narrow, ends;
  std::string count = "%1 of %2";
};

/// Adds an array's median, its bands (the one from 25 to 75 % if it has a label), the ends of its
/// simulations and the numbers of those that came deep to a figure.
///
/// @param dash  Of the median up to where all simulations came.
void addForceCourse(figures::Figure& figure, const ArrayPlan& plan, const ForceLabels& labels,
                    const figures::Ink& ink, double dash = 0.0);

}  // namespace perilymph::planning
