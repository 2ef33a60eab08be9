// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Two successive links of the rod.

#include "lanes/Lanes.h"
#include "rod/RodKinematics.h"

namespace perilymph::mechanics {

/// Two successive links and the discrete curvature between them, at one node or at four.
template <class T>
struct Joint {
  Triple<T> last;  ///< Tangent of the link before.
  Triple<T> next;  ///< Tangent of the link after.
  T cosine;        ///< Cosine of the angle between them.
  T c;             ///< 1 / (1 + cosine)

  PERILYMPH_IN_LANES Joint(const RodKinematics& rod, std::size_t i) noexcept
      : last(load<T>(rod.tangent_W, i - 1)),
        next(load<T>(rod.tangent_W, i)),
        cosine(dot(last, next)),
        c(1.0 / larger(1.0 + cosine, 1e-3))
  {
  }

  /// Discrete curvature w = 2 (t - p) / (1 + t . p), a vector in the plane of both tangents that
  /// points to the inside of the bend. For small angles its length is the angle between them.
  PERILYMPH_IN_LANES Triple<T> bend_W() const noexcept
  {
    const T twice = 2.0 * c;
    return twice * (next - last);
  }
};

}  // namespace perilymph::mechanics
