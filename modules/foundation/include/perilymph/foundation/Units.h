// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Quantities with a dimension, for every interface of the program: files, windows, plug-ins,
// catalogs. Internally numbers are SI doubles; the name of any other number ends with its unit.

#include <compare>

namespace perilymph {

/// A number with a dimension, stored in SI. Every conversion names its unit.
template <class Dimension>
class Quantity {
public:
  constexpr Quantity() = default;
  static constexpr Quantity fromSi(double value) { return Quantity(value); }
  constexpr double si() const { return si_; }

  friend constexpr auto operator<=>(const Quantity&, const Quantity&) = default;
  friend constexpr Quantity operator+(Quantity a, Quantity b) { return fromSi(a.si_ + b.si_); }
  friend constexpr Quantity operator-(Quantity a, Quantity b) { return fromSi(a.si_ - b.si_); }
  friend constexpr Quantity operator-(Quantity a) { return fromSi(-a.si_); }
  friend constexpr Quantity operator*(double k, Quantity a) { return fromSi(k * a.si_); }
  friend constexpr double operator/(Quantity a, Quantity b) { return a.si_ / b.si_; }

private:
  explicit constexpr Quantity(double si) : si_(si) {}
  double si_ = 0.0;
};

using Length = Quantity<struct LengthDimension>;                      ///< meter
using Angle = Quantity<struct AngleDimension>;                        ///< radian
using Force = Quantity<struct ForceDimension>;                        ///< newton
using Speed = Quantity<struct SpeedDimension>;                        ///< meter per second
using Duration = Quantity<struct DurationDimension>;                  ///< second
using Mass = Quantity<struct MassDimension>;                          ///< kilogram
using Stiffness = Quantity<struct StiffnessDimension>;                ///< newton per meter
using Damping = Quantity<struct DampingDimension>;                    ///< newton second per meter
using Modulus = Quantity<struct ModulusDimension>;                    ///< pascal
using BendingStiffness = Quantity<struct BendingStiffnessDimension>;  ///< newton square meter
using Curvature = Quantity<struct CurvatureDimension>;                ///< one over meter

inline constexpr double pi = 3.14159265358979323846;

constexpr Length meters(double value) { return Length::fromSi(value); }
constexpr Length millimeters(double value) { return Length::fromSi(value / 1e3); }
constexpr double inMillimeters(Length length) { return length.si() * 1e3; }

constexpr Angle radians(double value) { return Angle::fromSi(value); }
constexpr Angle degrees(double value) { return Angle::fromSi(value * (pi / 180.0)); }
constexpr double inDegrees(Angle angle) { return angle.si() * (180.0 / pi); }

constexpr Force newtons(double value) { return Force::fromSi(value); }
constexpr Force millinewtons(double value) { return Force::fromSi(value / 1e3); }
constexpr double inNewtons(Force force) { return force.si(); }
constexpr double inMillinewtons(Force force) { return force.si() * 1e3; }

constexpr Speed metersPerSecond(double value) { return Speed::fromSi(value); }
constexpr Speed millimetersPerSecond(double value) { return Speed::fromSi(value / 1e3); }
constexpr double inMillimetersPerSecond(Speed speed) { return speed.si() * 1e3; }

constexpr Duration seconds(double value) { return Duration::fromSi(value); }
constexpr Duration milliseconds(double value) { return Duration::fromSi(value / 1e3); }
constexpr double inSeconds(Duration time) { return time.si(); }
constexpr double inMilliseconds(Duration time) { return time.si() * 1e3; }

constexpr Mass kilograms(double value) { return Mass::fromSi(value); }
constexpr Stiffness newtonsPerMeter(double value) { return Stiffness::fromSi(value); }
constexpr Modulus megapascals(double value) { return Modulus::fromSi(value * 1e6); }
constexpr double inMegapascals(Modulus modulus) { return modulus.si() / 1e6; }
constexpr Damping newtonSecondsPerMeter(double value) { return Damping::fromSi(value); }
constexpr BendingStiffness newtonSquareMeters(double value)
{
  return BendingStiffness::fromSi(value);
}
constexpr Curvature perMillimeter(double value) { return Curvature::fromSi(value * 1e3); }
constexpr double inPerMillimeter(Curvature curvature) { return curvature.si() / 1e3; }

}  // namespace perilymph
