// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/DuctLength.h"

#include <cmath>

namespace perilymph::anatomy {

Length ellipticCircularBasalTurn(Length a, Length b)
{
  return 1.18 * a + 2.69 * b - Length::fromSi(std::sqrt(0.72 * a.si() * b.si()));
}

Length ellipticCircularDuctLength(Length a, Length b)
{
  const Length narrower = millimeters(1.0);
  return 1.71 * ellipticCircularBasalTurn(a - narrower, b - narrower) + millimeters(0.18);
}

}  // namespace perilymph::anatomy
