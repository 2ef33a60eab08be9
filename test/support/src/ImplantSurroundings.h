// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What surrounds the array in an implanted ear: its silicone, its lead, the drilled way to it. Frame W, mm.

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "ImplantGeometry.h"

namespace perilymph::test {

/// Perilymph and soft tissue [HU].
inline constexpr double fluidHu = 60.0;

/// An ear without an implant.
struct EarContent {
  std::function<double(const Eigen::Vector3d& point_W, double cell)> intensity;  ///< [HU]
  /// Depth in the labyrinth that is not drilled; negative outside.
  std::function<double(const Eigen::Vector3d& point_W)> inside;
};

class ImplantSurroundings {
public:
  ImplantSurroundings(EarContent ear, const electrode::ArrayDesign& array, const Course& course,
                      bool hasOldLead, std::uint64_t seed);

  /// Intensity without metal, before any blur [HU].
  double intensity(const Eigen::Vector3d& point_W, double cell) const;

  const std::vector<MetalPiece>& metal() const { return metal_; }  ///< Everything in view.
  const std::vector<Eigen::Vector3d>& oldLead_W() const
  {
    return old_;
  }  ///< 0.1 mm apart; empty without one.

private:
  /// A ball of a carrier's or a lead's silicone, and of what was drilled around it.
  struct Ball {
    Eigen::Vector3d center;
    double silicone, drilled;  // radii
  };
  void addLead(const electrode::ArrayDesign& array, const Course& course);
  void addOldLead(const Course& course, Dice& dice);
  void addWires(const std::vector<Eigen::Vector3d>& points, double number);
  void addBall(const Ball& ball);
  std::size_t boxOf(const Eigen::Vector3d& point) const;

  EarContent ear_;
  double cavity_;  // its content [HU]
  std::vector<Eigen::Vector3d> lead_, old_;
  std::vector<Ball> balls_;
  std::vector<std::vector<int>> near_;  ///< Balls that reach into each box.
  std::vector<MetalPiece> metal_;
};

}  // namespace perilymph::test
