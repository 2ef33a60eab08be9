// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Distance of the electrode contacts from the modiolus, a quality measure of perimodiolar arrays.

#include <vector>

#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/charts/ChartStyle.h"
#include "perilymph/figures/Drawing.h"

namespace perilymph::charts {

/// One contact of the array.
struct ContactDistance {
  bool isInside = false;  ///< If false, nothing below is set.
  double angle_deg = 0.0;
  /// Distance from the array's center line to the inner wall in the direction of the modiolar axis;
  /// negative if the array is beyond the wall, above the partition, or there is none.
  double toInnerWall_mm = -1.0;
  bool isAbove = false;  ///< Above the cochlear partition, in the scala vestibuli.
};

/// Distances of all contacts, from the tip.
std::vector<ContactDistance> contactDistances(const ArrayInScala& now);

/// The distances [mm] as a bar chart over the contact numbers, 1 at the tip, with their mean. Contacts
/// above the partition are red crosses.
figures::Drawing drawContactDistances(const std::vector<ContactDistance>& contacts, double width,
                                      double height, const ChartStyle& style = {});

}  // namespace perilymph::charts
