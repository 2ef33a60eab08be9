// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/IndividualShape.h"

#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {

double AngularVariation::at(double angle) const
{
  if (amplitude == 0.0) return 0.0;
  double sum = 0.0;
  for (const auto& [frequency, phase] : waves) sum += sineCosine(frequency * angle + phase).cosine;
  return amplitude * sum;
}

double IndividualShape::sectionAt(double angle) const
{
  return sections.amplitude == 0.0 ? section : section * exponential(sections.at(angle));
}

}  // namespace perilymph::anatomy
