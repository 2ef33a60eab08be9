// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/Opening.h"

namespace perilymph::mechanics {

Opening roundWindow()
{
  return {millimeters(1.37), millimeters(1.91), millimeters(0.1), millimeters(0), millimeters(0)};
}

Opening cochleostomy(Length diameter)
{
  return {diameter, diameter, millimeters(0.1), millimeters(0), millimeters(0)};
}

}  // namespace perilymph::mechanics
