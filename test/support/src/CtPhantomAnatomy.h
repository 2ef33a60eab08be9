// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The geometry of a phantom: kidney-shaped sections along a warped spiral, and its surroundings.
// Frame W, mm.

#include <Eigen/Core>
#include <array>
#include <random>
#include <vector>

#include "perilymph/test/CtPhantom.h"

namespace perilymph::test {

/// Independent normal and uniform random numbers of a seed.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double normal();
  double uniform(double low, double high);

private:
  std::mt19937_64 engine_;
};

/// A smooth random function of the angle: a few cosines with random phases and unit standard
/// deviation.
class Wobble {
public:
  Wobble(Dice& dice, double shortestPeriod_rad);
  double operator()(double angle) const;

private:
  std::array<double, 4> frequency_{}, phase_{};
};

/// One section: a kidney in the half-plane, u outward and v along the axis from its center.
struct KidneySection {
  double middleRadius, middleHeight;
  double outward, inward, half;  ///< Semi-axes [mm].
  double shear, bend;            ///< v of the midline at u: shear u + bend u^2.
};

class PhantomAnatomy {
public:
  explicit PhantomAnatomy(std::uint64_t seed, const PhantomCondition& condition = {});

  /// Depth in the cochlea's lumen [mm], negative outside; near the wall equal to the distance.
  double inside(const Eigen::Vector3d& point_W) const { return deepest(point_W).inside; }

  KidneySection sectionAt(double angle) const;
  Eigen::Vector3d roundWindow_W() const;
  /// Height of the spiral lamina above the midline of a section, over the section's half height.
  double laminaAt(double angle) const;
  static constexpr double laminaHalf_mm = 0.11;  ///< Half its thickness.
  double firstAngle() const { return first_; }
  double lastAngle() const { return last_; }

  /// Content of a voxel of the fine grid, before blur.
  /// @param lumen  Intensity of the lumen.
  /// @param cell   Edge of the voxel [mm].
  double intensity(const Eigen::Vector3d& point_W, double lumen, double cell) const;

private:
  struct Ball {
    Eigen::Vector3d center;
    double radius;
  };
  struct Depth {
    double inside, angle;  ///< Angle of the turn that contains the point or is nearest.
  };
  Depth deepest(const Eigen::Vector3d& point_W) const;
  /// The intensity with the implant's, if it has one.
  double withImplant(const Eigen::Vector3d& p, double value, double cell) const;
  double surroundings(const Eigen::Vector3d& p, double inLumen, double cell) const;
  double texture(const Eigen::Vector3d& p) const;

  PhantomCondition condition_;
  double first_, last_;
  double size_, stretch_, rise_, height_, skew_;
  std::vector<double> angle_, outer_, center_, heightST_, width_;
  std::vector<Wobble> wobbles_;
  std::vector<Ball> cells_;
  std::array<Eigen::Vector4d, 6> waves_;
  double capsule_, modiolus_, niche_, canal_, window_, recess_;
  double modiolusTop_ = 2.6;          ///< Height of its upper end.
  Eigen::Vector3d lean_;              ///< Lean of the round-window niche.
  std::vector<KidneySection> table_;  ///< Every 2 degrees from the first angle.
};

}  // namespace perilymph::test
