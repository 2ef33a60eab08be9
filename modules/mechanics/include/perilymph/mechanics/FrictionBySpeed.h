#pragma once

// Friction that rises and falls with speed, as measured point by point.

#include <array>
#include <cstddef>
#include <vector>

#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// The coefficient of friction of a sliding node by its speed: through every given point, between
/// two of them monotone (a cubic with the slopes of Fritsch and Butland 1984), so that no hump
/// appears that was not measured. Below the first speed and above the last one it stays.
class FrictionBySpeed {
public:
  static constexpr std::size_t maxPoints = 8;

  /// No points: the speed follows the two coefficients of FrictionLaw.
  FrictionBySpeed() = default;
  /// @throws std::invalid_argument with a sentence unless there are 1 to 8 points with growing
  /// speeds from 0 on and coefficients from 0 to 2.
  FrictionBySpeed(const std::vector<Speed>& speeds, const std::vector<double>& coefficients);

  bool isEmpty() const noexcept { return points_ == 0; }
  /// The coefficient at a speed of 0 or more [m/s]; only with points. Real-time safe.
  double at(double speed) const noexcept;
  /// The least and the greatest one; only with points.
  double minimum() const noexcept;
  double maximum() const noexcept;
  void addTo(Hash& hash) const noexcept;

private:
  std::size_t points_ = 0;
  std::array<double, maxPoints> speed_{};        // [m/s]
  std::array<double, maxPoints> coefficient_{};  // at each speed
  std::array<double, maxPoints> slope_{};        // of the coefficient there [s/m]
};

}  // namespace perilymph::mechanics
