// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The template spiral of the published and the Clark anatomy.

namespace perilymph::anatomy {

/// Distance of the template spiral from the modiolar axis [m], by the spiral's own angle, above 5
/// degrees: Cohen 1996 with Clark's apical term (2011).
///
///     R = C (1 - D ln(angle - 5 deg))                     below 100 degrees
///     R = A exp(-B (0.0002 angle^2 + 0.98 angle))         above
double cohenRadius(double spiral_deg);

}  // namespace perilymph::anatomy
