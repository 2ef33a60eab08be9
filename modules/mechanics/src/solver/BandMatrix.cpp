// SPDX-License-Identifier: BSD-3-Clause
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

void BandMatrix::holdFirst() noexcept
{
  diagonal.set(0, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0});
  if (blocks() > 1) beside.set(1, {});
  if (blocks() > 2) beyond.set(2, {});
  firstIsHeld = true;
}

}  // namespace perilymph::mechanics
