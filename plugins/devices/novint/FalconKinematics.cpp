// SPDX-License-Identifier: BSD-3-Clause
#include "FalconKinematics.h"

#include <cmath>

namespace perilymph::novint {

namespace {

constexpr double pi = 3.14159265358979323846;

using Matrix = std::array<Vector, 3>;  // rows

Vector cross(const Vector& a, const Vector& b) noexcept
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) noexcept
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// x with sum over k of columns[k] x[k] = right, by Cramer's rule. None if nearly singular.
std::optional<Vector> solved(const Matrix& columns, const Vector& right) noexcept
{
  const double determinant = dot(columns[0], cross(columns[1], columns[2]));
  // Slopes are about 0.1 m long; below a thousandth of their product the directions are parallel.
  if (!(std::fabs(determinant) > 1e-6)) return std::nullopt;
  return Vector{dot(right, cross(columns[1], columns[2])) / determinant,
                dot(columns[0], cross(right, columns[2])) / determinant,
                dot(columns[0], cross(columns[1], right)) / determinant};
}

Matrix transposed(const Matrix& m) noexcept
{
  return {Vector{m[0][0], m[1][0], m[2][0]}, Vector{m[0][1], m[1][1], m[2][1]},
          Vector{m[0][2], m[1][2], m[2][2]}};
}

}  // namespace

double armAngle(int count) noexcept
{
  constexpr double countsPerTurn = 4 * 320;
  constexpr double gear = 0.01425 / 0.110;
  constexpr double atHome = 35.0 / 180.0 * pi;
  return atHome + gear * 2.0 * pi / countsPerTurn * count;
}

FalconKinematics::FalconKinematics(const FalconGeometry& geometry) noexcept : geometry_(geometry)
{
  for (std::size_t i = 0; i < 3; ++i) {
    cosine_[i] = std::cos(geometry.arms[i]);
    sine_[i] = std::sin(geometry.arms[i]);
  }
}

std::optional<FalconKinematics::Arm> FalconKinematics::arm(std::size_t index, double angle,
                                                           const Vector& position) const noexcept
{
  const double cosine = cosine_[index], sine = sine_[index];
  const double u = cosine * position[0] + sine * position[1] - geometry_.baseU;
  const double v = -sine * position[0] + cosine * position[1] - geometry_.baseV;
  const double side = v + geometry_.gripV;
  const double squared = geometry_.shin * geometry_.shin - side * side;
  if (!(squared > 0.0)) return std::nullopt;
  const double inPlane = std::sqrt(squared);
  const double length = geometry_.shinOffsets + inPlane;
  const double out = u + geometry_.gripU - geometry_.thigh * std::cos(angle);
  const double up = position[2] - geometry_.thigh * std::sin(angle);
  const double aside = length * side / inPlane;
  return Arm{0.5 * (out * out + up * up - length * length),
             {out * cosine - aside * sine, out * sine + aside * cosine, up},
             geometry_.thigh * (out * std::sin(angle) - up * std::cos(angle))};
}

std::optional<Vector> FalconKinematics::position(const Vector& angles,
                                                 const Vector& nearby) const noexcept
{
  constexpr int maxSteps = 30;
  constexpr double settled = 1e-12;  // [m]
  Vector at = nearby;
  for (int step = 0; step < maxSteps; ++step) {
    Matrix slopes;
    Vector residuals;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto one = arm(i, angles[i], at);
      if (!one) return std::nullopt;
      slopes[i] = one->slope;
      residuals[i] = -one->residual;
    }
    const auto change = solved(transposed(slopes), residuals);
    if (!change) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) at[k] += (*change)[k];
    // The branch away from the base; the other one lies behind the motors.
    if (dot(*change, *change) < settled * settled)
      return at[2] > 0.0 ? std::optional<Vector>(at) : std::nullopt;
  }
  return std::nullopt;
}

Vector FalconKinematics::torques(const Vector& angles, const Vector& position,
                                 const Vector& force) const noexcept
{
  Matrix slopes;
  Vector byAngle;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto one = arm(i, angles[i], position);
    if (!one) return {};
    slopes[i] = one->slope;
    byAngle[i] = one->slopeByAngle;
  }
  // The forces of the arms on the grip are along their slopes.
  const auto shares = solved(slopes, force);
  if (!shares) return {};
  return {-(*shares)[0] * byAngle[0], -(*shares)[1] * byAngle[1], -(*shares)[2] * byAngle[2]};
}

}  // namespace perilymph::novint
