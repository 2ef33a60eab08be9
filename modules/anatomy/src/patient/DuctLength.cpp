// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/DuctLength.h"

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Normal.h"

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

Length ductLengthFromA(Length a) { return 4.16 * a - millimeters(4.0); }

Length ductLengthError(Length a, Length b, const BasalTurnErrors& errors)
{
  const Length length = ellipticCircularDuctLength(a, b);
  const double byA = (ellipticCircularDuctLength(a + errors.a, b) - length).si();
  const double byB = (ellipticCircularDuctLength(a, b + errors.b) - length).si();
  return Length::fromSi(
      std::sqrt(std::max(0.0, byA * byA + byB * byB + 2.0 * errors.ab * byA * byB)));
}

Length ductLengthFormulaError(Length a, Length b)
{
  const Length apart = ductLengthFromA(a) - ellipticCircularDuctLength(a, b);
  return Length::fromSi(std::fabs(apart.si()) / halfWidth95);
}

}  // namespace perilymph::anatomy
