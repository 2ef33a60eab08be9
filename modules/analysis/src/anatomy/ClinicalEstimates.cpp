// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ClinicalEstimates.h"

#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Sentence.h"

namespace perilymph::analysis {

namespace {

constexpr const char* alexiades = "Alexiades 2015, Otol Neurotol 36:904";
const Sentence schurzig{
    "Schurzig et al. 2018; constants unverified, within 1 % of the average scala tympani "
    "(Froehlich et al. 2024)"};

}  // namespace

Measure ductLength(const char* key, Length a, Length b)
{
  return {key, inMillimeters(anatomy::ellipticCircularDuctLength(a, b)),
          Sentence{"1.71 L + 0.18, L = 1.18 (A - 1) + 2.69 (B - 1) - sqrt(0.72 (A - 1) (B - 1))"},
          schurzig, inMillimeters(anatomy::ductLengthFormulaError(a, b))};
}

Length alexiadesTwoTurns(Length a) { return 3.65 * (a - millimeters(1.0)); }

Length escudeOuterWall(Length a, Angle angle)
{
  return 2.62 * logarithm(1.0 + inDegrees(angle) / 235.0) * a;
}

std::vector<Measure> clinicalEstimates(Length a, Length b)
{
  const std::string escude =
      "Escude et al. 2006; constants unverified, within 2.5 % of the average scala tympani "
      "(Froehlich et al. 2024)";
  return {
      {"alexiades_two_turns_oc_mm", inMillimeters(alexiadesTwoTurns(a)), "3.65 (A - 1)", alexiades},
      {"escude_outer_wall_360_mm", inMillimeters(escudeOuterWall(a, degrees(360))),
       "2.62 A ln(1 + 360 / 235)", escude},
      {"escude_outer_wall_675_mm", inMillimeters(escudeOuterWall(a, degrees(675))),
       "2.62 A ln(1 + 675 / 235)", escude},
      {"eca_outer_wall_360_mm", inMillimeters(anatomy::ellipticCircularBasalTurn(a, b)),
       "1.18 A + 2.69 B - sqrt(0.72 A B)", schurzig},
      {"alexiades_cdl_oc_mm", inMillimeters(anatomy::ductLengthFromA(a)), "4.16 A - 4", alexiades},
      {"pietsch_turns", anatomy::turnAngle(anatomy::likeliestHalfDiameters(a, b)) / degrees(360),
       Sentence{"turn angle of the likeliest half-diameters with these A and B / 360 deg"},
       Sentence{"Pietsch et al. 2017, Sci Rep, n = 138; constants seen in public code"}}};
}

}  // namespace perilymph::analysis
