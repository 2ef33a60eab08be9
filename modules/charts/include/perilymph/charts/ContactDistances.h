#pragma once

// How near the contacts come to the modiolus: what a perimodiolar array is judged by.

#include <vector>

#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/charts/ChartStyle.h"
#include "perilymph/figures/Drawing.h"

namespace perilymph::charts {

/// One contact of the array.
struct ContactDistance {
  bool isInside = false;  ///< If not, nothing below is set.
  double angle_deg = 0.0;
  /// From the array's center line to the inner wall on the way to the modiolar axis; negative where
  /// the array lies beyond the wall or no wall is on that way.
  double toInnerWall_mm = -1.0;
};

/// Distances of every contact, from the tip on.
std::vector<ContactDistance> contactDistances(const ArrayInScala& now);

/// The distances [mm] as pins over the contacts' numbers, 1 at the tip, with their mean.
figures::Drawing drawContactDistances(const std::vector<ContactDistance>& contacts, double width,
                                      double height, const ChartStyle& style = {});

}  // namespace perilymph::charts
