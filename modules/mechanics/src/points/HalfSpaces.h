// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Projection of a goal onto the intersection of a few half-spaces.

#include <Eigen/Core>
#include <array>

namespace perilymph::mechanics {

/// A point x is allowed if normal . x >= bound.
struct HalfSpace {
  Eigen::Vector3d normal;  ///< Unit.
  double bound = 0.0;      ///< [m]
  double distance = 0.0;   ///< Distance of its triangle [m]; the farthest are dropped first.
};

/// Whether a goal is allowed, is constrained, or has no allowed point near it.
enum class Allowed { yes, heldBack, nowhere };

/// At most 32 half-spaces, and the projection onto their intersection.
class HalfSpaces {
public:
  void clear() noexcept { count_ = 0; }
  /// Adds a half-space. If the capacity is exceeded, the nearest ones are kept.
  void add(const HalfSpace& space) noexcept;

  /// Moves `place` from the goal to the nearest allowed point.
  ///
  /// Adds the most violated half-space and keeps at most three active ones (an active-set method;
  /// the result is the projection onto a convex set and therefore unique). Bounded; real-time safe.
  Allowed project(const Eigen::Vector3d& goal, Eigen::Vector3d& place) const noexcept;

private:
  static constexpr int capacity = 32;
  static constexpr int maxActive = 3;
  struct Holding {
    std::array<int, maxActive> index{};
    int count = 0;
  };

  const HalfSpace& at(int index) const noexcept { return items_[static_cast<std::size_t>(index)]; }
  int maxViolated(const Eigen::Vector3d& place) const noexcept;
  bool holds(const Holding& set, const Eigen::Vector3d& goal,
             Eigen::Vector3d& place) const noexcept;

  std::array<HalfSpace, capacity> items_;
  int count_ = 0;
};

}  // namespace perilymph::mechanics
