// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An array in the lower scala of a phantom: its course, and the metal in it. Frame W, mm.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "CtPhantomAnatomy.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/test/ImplantPhantom.h"

namespace perilymph::test {

/// The lower scala of a phantom: its kidneys below the spiral lamina.
std::shared_ptr<const anatomy::ScalaTympani> lowerScala(const PhantomAnatomy& anatomy);

/// True if a point in the lumen of the turn at an angle lies above the partition.
bool isAbovePartition(const PhantomAnatomy& anatomy, const Eigen::Vector3d& point_W, double angle);

/// A curve by equal steps of its length, the tip first.
struct Course {
  static constexpr double step = 0.02;  // [mm]
  std::vector<Eigen::Vector3d> points_W;
  std::vector<double> angles;  ///< About the axis, continued from the opening [rad].
  double opening = 0.0;        ///< Distance of the plane of the round window from the tip.
  double fold = 0.0;           ///< Distance of the turning point from the tip; 0 without a fold.

  double length() const { return step * static_cast<double>(points_W.size() - 1); }
  Eigen::Vector3d at(double fromTip) const;
  Eigen::Vector3d tangent(double fromTip) const;  ///< Unit, toward the tip.
  double angleAt(double fromTip) const;
};

/// The course of an inserted array.
Course insertedCourse(std::uint64_t seed, const PhantomAnatomy& anatomy,
                      const electrode::ArrayDesign& array, const ImplantCondition& condition);

/// The same in any scala tympani, as the engine gives it: neither folded nor translocated.
Course insertedCourse(std::uint64_t seed, std::shared_ptr<const anatomy::ScalaTympani> scala,
                      const electrode::ArrayDesign& array, const ImplantCondition& condition);

/// A small piece of metal.
struct MetalPiece {
  Eigen::Vector3d point;
  double volume_mm3;
  bool isContact;  ///< Platinum; else platinum-iridium of the wires.
};

/// The platinum of a contact, and the wires of the array.
std::vector<MetalPiece> platinumOf(const electrode::ArrayDesign& array, const Course& course,
                                   std::size_t contact);
std::vector<MetalPiece> wiresOf(const electrode::ArrayDesign& array, const Course& course);

/// A shipped array by its name. @throws std::runtime_error if there is none.
electrode::ArrayDesign shippedArray(const std::string& name);

}  // namespace perilymph::test
