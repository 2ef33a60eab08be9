// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/Opening.h"

namespace perilymph::mechanics {

Opening roundWindow()
{
  Opening opening;
  opening.width = millimeters(1.37);
  opening.height = millimeters(1.91);
  opening.edgeRadius = millimeters(0.1);
  return opening;
}

Opening cochleostomy(Length diameter)
{
  Opening opening;
  opening.width = opening.height = diameter;
  opening.edgeRadius = millimeters(0.1);
  return opening;
}

}  // namespace perilymph::mechanics
