// SPDX-License-Identifier: BSD-3-Clause
#include "solver/BandMatrix.h"

#include <algorithm>

namespace perilymph::mechanics {

void BandMatrix::clear() noexcept
{
  std::fill(diagonal.begin(), diagonal.end(), SymmetricBlock<double>{});
  std::fill(beside.begin(), beside.end(), Block<double>{});
  std::fill(beyond.begin(), beyond.end(), Block<double>{});
  firstIsHeld = false;
}

void BandMatrix::holdFirst() noexcept
{
  diagonal[0] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
  if (blocks() > 1) beside[1] = Block<double>{};
  if (blocks() > 2) beyond[2] = Block<double>{};
  firstIsHeld = true;
}

}  // namespace perilymph::mechanics
