// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force that pushes a tapered elastic rod into a planar spiral channel, in closed form: the rod has
// the channel's curvature, its tip presses on the wall, and friction grows the compression by the
// capstan law. No inertia, no clearance, no buckling.

#include <span>
#include <vector>

namespace perilymph::validation {

/// A channel whose center line is straight at the mouth and then a logarithmic spiral, whose radius of
/// curvature is radiusAt10 (1 - tightening (s - 10 mm)) at the length s. SI units.
struct SpiralChannel {
  double radiusAt10 = 2.6e-3;
  double tightening = 35.0;  ///< Per meter of length.
  double start = 4.3e-3;     ///< Middle of the stretch in which the curvature sets in.
  double onset = 2.0e-3;     ///< Length of that stretch.

  double curvatureAt(double length) const noexcept;
};

/// The force over a depth of insertion, divided by the bending stiffness at the tip [1/m^2].
///
/// With the curvature k(s), the angle p(s) from the mouth, and the moment M(s) = EI(z - s) k(s) of a rod
/// whose tip is at z, the compression obeys P' = k M' - mu k P along s, and at the tip it is
/// EI(0) k(z)^2 (1 + mu cot(a) / 2), where a is the angle between tip and wall. The force is P(0).
class ChannelForce {
public:
  /// @param deepest  Depth up to which forces are wanted [m].
  ChannelForce(const SpiralChannel& channel, double friction, double deepest);

  /// Parts of the force at a depth; it is linear in the array's shape.
  struct Parts {
    double tip = 0.0, tipFriction = 0.0, uniform = 0.0, growing = 0.0;

    /// @param growth        r of EI(u) = EI(0) (1 + r u / 15 mm), u from the tip.
    /// @param tipCotangent  cot(a).
    double force(double growth, double tipCotangent) const noexcept
    {
      return tip + tipCotangent * tipFriction + uniform + growth * growing;
    }
  };
  /// @param depth  Up to `deepest`, on whole steps of 0.05 mm.
  Parts at(double depth) const;

private:
  double friction_;
  std::vector<double> curvature_;  // at the ends of the steps
  std::vector<double> gain_;       // e^(mu p), there
};

}  // namespace perilymph::validation
