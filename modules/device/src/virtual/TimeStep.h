// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Time step of an input device without hardware.

namespace perilymph::device {

/// Returns a valid time step [s]. @throws std::invalid_argument outside 0.1 ms to 10 ms.
double checkedTimeStep(double timeStep);

}  // namespace perilymph::device
