#pragma once

// The time between two reads of a hand that has no hardware.

namespace perilymph::device {

/// Gives back a time step [s] that a hand can run at. @throws std::invalid_argument outside 0.1 ms
/// to 10 ms.
double checkedTimeStep(double timeStep);

}  // namespace perilymph::device
