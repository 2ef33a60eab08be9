#pragma once

// The place nearest to a goal that a few planes allow.

#include <Eigen/Core>
#include <array>

namespace perilymph::mechanics {

/// A place x is allowed where normal . x >= bound.
struct HalfSpace {
  Eigen::Vector3d normal;  ///< Unit.
  double bound = 0.0;      ///< [m]
  double distance = 0.0;   ///< Distance of its triangle [m]; the farthest are dropped first.
};

/// Whether a goal is allowed, is held back, or has no allowed place near it at all.
enum class Allowed { yes, heldBack, nowhere };

/// At most 32 half-spaces, and where a goal may come to lie among them.
class HalfSpaces {
public:
  void clear() noexcept { count_ = 0; }
  /// If there are more than fit, the nearest stay.
  void add(const HalfSpace& space) noexcept;

  /// Moves `place` from the goal to the allowed place nearest to it.
  ///
  /// Adds the half-space violated most, and keeps of it and those that held so far the at most
  /// three that push (an active set; the answer is the projection onto a convex set, so it is the
  /// only one). Bounded; real-time safe.
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
