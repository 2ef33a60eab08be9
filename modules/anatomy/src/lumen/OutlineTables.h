// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Conversion of outlines, given at every angle, to the tables of a scala tympani.

#include <functional>
#include <string>

#include "lumen/Outline.h"
#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::anatomy {

/// A source's description of one half-plane.
struct OutlineAtAngle {
  Outline outline;
  double planRadius;     ///< Distance of the organ-of-Corti path from the axis [m].
  double membraneWidth;  ///< [m]
};
using OutlineSource = std::function<OutlineAtAngle(double angle)>;

/// Sections every 1.5 degrees in polar coordinates about their centroids, eased into the lead-in.
/// The basilar membrane lies in the roof, its inner edge above the centroid.
///
/// @throws std::invalid_argument if an outline is not star-shaped about its centroid.
SectionTables tablesFrom(const OutlineSource& source, const std::string& name, double lastAngle,
                         double leadIn);

}  // namespace perilymph::anatomy
