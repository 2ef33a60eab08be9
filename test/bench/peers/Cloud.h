// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The query for every library: the distance from the center of a sphere in the duct to the wall.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::bench {

/// Half the thickness of an array near its tip, and the radius of every sphere [m].
constexpr double sphereRadius = 0.25e-3;
/// Maximum distance of a center from the wall [m]: half of the spheres are in contact.
constexpr double farthest = 0.5e-3;
/// Range of the search for libraries with a limit [m]: the maximum distance plus the error of the
/// facets.
constexpr double reach = 0.6e-3;

/// Centers of spheres in the mean scala, 0 to 0.5 mm from its wall, the same on every machine, with
/// the distances of the project's lumen.
struct Cloud {
  std::vector<Eigen::Vector3d> centers_W;   ///< [m]
  std::vector<anatomy::LumenTrack> tracks;  ///< The turn of each center.
  std::vector<double> distances;            ///< From the project's lumen [m].
};

/// The mean scala with a lead-in of 1 mm, built once, or the error.
///
/// Not the published one: from 230 degrees its turns overlap (its roof at 300 degrees is 0.4 mm
/// above the floor of the next turn), so the nearest triangle may belong to another turn than the
/// center, and libraries do not know turns. The turns of the mean scala are at least 0.6 mm apart.
const Result<std::shared_ptr<const anatomy::ScalaTympani>>& builtMean();

/// The mean scala. It must have been built.
inline const anatomy::ScalaTympani& meanScala() { return **builtMean(); }

/// A thousand random centers, computed once. The scala must have been built.
const Cloud& cloud();

/// The wall as flat triangles.
struct Facets {
  anatomy::Surface surface_mm;
  double surfaceDistance =
      0.0;  ///< Maximum distance of the true wall from the triangles, at 4000 points [m].
};

/// The wall as at most this number of triangles, computed once. The scala must have been built.
const Facets& facets(int maxTriangles);

}  // namespace perilymph::bench
