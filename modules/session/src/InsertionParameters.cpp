// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/InsertionParameters.h"

#include <cmath>

namespace perilymph::session {

Length fullTravel(const electrode::ArrayDesign& array, Length startInside)
{
  return millimeters(std::floor(inMillimeters(array.insertable - startInside) * 1e3) / 1e3);
}

}  // namespace perilymph::session
