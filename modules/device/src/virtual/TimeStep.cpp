// SPDX-License-Identifier: BSD-3-Clause
#include "virtual/TimeStep.h"

#include <stdexcept>
#include <string>

namespace perilymph::device {

double checkedTimeStep(double timeStep)
{
  if (!(timeStep >= 1e-4 * (1.0 - 1e-9) && timeStep <= 1e-2 * (1.0 + 1e-9)))  // also catches NaN
    throw std::invalid_argument("The time step of a hand is " + std::to_string(timeStep * 1e3) +
                                " ms; it must be between 0.1 and 10 ms.");
  return timeStep;
}

}  // namespace perilymph::device
