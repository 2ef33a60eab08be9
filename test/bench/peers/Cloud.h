// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The question put to every library: how far is the wall from the center of a sphere in the duct?

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::bench {

/// Half the thickness of an array near its tip, and the radius of every sphere [m].
constexpr double sphereRadius = 0.25e-3;
/// No center is farther from the wall [m]: half of them are in contact, half are not.
constexpr double farthest = 0.5e-3;
/// Beyond this no library that can be told so need look [m]: the farthest and what facets cut off.
constexpr double reach = 0.6e-3;

/// Centers of spheres in the mean scala, 0 to 0.5 mm from its wall, the same on every machine, and
/// what our own lumen answers for each.
struct Cloud {
  std::vector<Eigen::Vector3d> centers_W;   ///< [m]
  std::vector<anatomy::LumenTrack> tracks;  ///< The turn each is in.
  std::vector<double> distances;            ///< By our own lumen [m].
};

/// The mean scala with a lead-in of 1 mm, built once; or why it was not.
///
/// Not the published one: from 230 degrees on its turns overlap (its roof at 300 degrees is 0.4 mm
/// above the floor of the turn over it), so the triangle nearest to a center may be of a turn that
/// the center is not in, and libraries that know no turns would answer another question. The turns
/// of the mean are at least 0.6 mm apart.
const Result<std::shared_ptr<const anatomy::ScalaTympani>>& builtMean();

/// The mean scala; it must have been built.
inline const anatomy::ScalaTympani& meanScala() { return **builtMean(); }

/// A thousand centers, drawn once. The scala must have been built.
const Cloud& cloud();

/// The wall in flat triangles.
struct Facets {
  anatomy::Surface surface_mm;
  double surfaceDistance =
      0.0;  ///< Maximum distance of the true wall from the triangles, over 4000 places [m].
};

/// The wall in at most so many triangles, cut once. The scala must have been built.
const Facets& facets(int maxTriangles);

}  // namespace perilymph::bench
