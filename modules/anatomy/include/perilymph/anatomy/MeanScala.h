// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The measured mean human scala tympani: 31 cross-sections of the average of 15 cochleae (Froehlich
// et al. 2024, CC BY 4.0, adapted; credit and license in the data file).

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/anatomy/IndividualShape.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// One cross-section of the mean scala tympani, in a half-plane through the modiolar axis.
struct MeasuredSection {
  static constexpr int harmonics = 4;

  double angle = 0.0;        ///< From the first section [rad].
  double innerRadius = 0.0;  ///< Minimum distance of the wall from the axis [m].
  double outerRadius = 0.0;  ///< Maximum distance of the wall from the axis [m].
  double height = 0.0;       ///< Height along the axis, floor to roof [m].
  double area = 0.0;         ///< [m^2]
  double inscribed = 0.0;    ///< Diameter of the largest inscribed circle [m].
  /// r + i z = sum of (real[k] + i imaginary[k]) e^(i (k - 4) t), counter-clockwise [m].
  std::array<double, 2 * harmonics + 1> real{}, imaginary{};
};

/// Reads the measured sections shipped with the program.
Result<std::vector<MeasuredSection>> loadMeasuredSections();

/// The mean scala tympani: measured to 675 degrees, extrapolated to 900 by the trend of its last
/// turn (confidence low) and closed by a rounded cap, with a straight lead-in before the round
/// window. Not real-time safe.
Result<std::shared_ptr<const ScalaTympani>> buildMean(Length leadIn);

/// Clinical measures of the outer wall: A from the round window through the modiolus to the
/// opposite wall, B perpendicular to it, and H along the modiolus from the lowest to the highest
/// wall.
struct BasalTurn {
  Length a, b;
  std::optional<Length> h;
};

/// The mean scala tympani scaled to a patient's A and B, and H if known: radii are scaled by the
/// ratio of the patient's most likely spiral to the mean's (Pietsch et al. 2017) and a correction
/// with two periods per turn, so that the resulting lumen has this A and B. Sections keep their
/// shape; without H the rise of the center line scales with the width of the basal turn.
Result<std::shared_ptr<const ScalaTympani>> buildMean(const std::string& label,
                                                      const BasalTurn& basalTurn, Length leadIn);

/// The same with an individual shape. A, B and H are kept; sections become no wider than half their
/// distance from the axis allows.
Result<std::shared_ptr<const ScalaTympani>> buildMean(const std::string& label,
                                                      const BasalTurn& basalTurn,
                                                      const IndividualShape& shape, Length leadIn);

}  // namespace perilymph::anatomy
