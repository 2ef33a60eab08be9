// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A curve over travel with constant memory: for each pixel column the minimum and maximum of the
// latest pass.

#include <cstdint>
#include <vector>

namespace perilymph::charts {

/// Direction of motion.
enum class Direction { in, out };

/// Forces over travel, separate for insertion and withdrawal: friction makes them differ, and a
/// single line through both would be a band.
class TravelColumns {
public:
  static constexpr double first_mm = -10.0;
  static constexpr double last_mm = 70.0;
  static constexpr double width_mm = 0.04;
  /// Return after which the direction is regarded as reversed; less is tremor.
  static constexpr double turn_mm = 0.1;

  TravelColumns();

  /// Adds a value. Values outside first_mm to last_mm or not finite are ignored.
  void append(double travel_mm, double force_mN);
  void clear();

  bool isEmpty() const noexcept { return isEmpty_; }
  double lastTravel_mm() const noexcept { return lastTravel_mm_; }
  double lastForce_mN() const noexcept { return lastForce_mN_; }
  double lowestForce_mN() const noexcept { return lowestForce_mN_; }
  double highestForce_mN() const noexcept { return highestForce_mN_; }
  double lowestTravel_mm() const noexcept { return lowestTravel_mm_; }
  double highestTravel_mm() const noexcept { return highestTravel_mm_; }

  /// Writes the curve of one direction as x and y, by travel; at most two points per column.
  void curve(Direction direction, std::vector<float>& travel_mm,
             std::vector<float>& force_mN) const;

private:
  struct Column {
    std::uint32_t pass = 0;  ///< 0: no value yet.
    float lowTravel_mm, low_mN;
    float highTravel_mm, high_mN;
  };
  using Columns = std::vector<Column>;

  void enter(double travel_mm, double force_mN);
  void turnRound(double travel_mm);

  Columns in_, out_;
  Direction direction_ = Direction::in;
  std::uint32_t pass_ = 1;
  double farthest_mm_ = 0.0;  ///< Extreme travel of this pass, in its direction.
  bool isEmpty_ = true;
  double lastTravel_mm_ = 0.0, lastForce_mN_ = 0.0;
  double lowestForce_mN_ = 0.0, highestForce_mN_ = 0.0;
  double lowestTravel_mm_ = 0.0, highestTravel_mm_ = 0.0;
};

}  // namespace perilymph::charts
