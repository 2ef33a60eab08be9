// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Surface output of `anatomy`.

#include <string>

#include "Commands.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/SurfaceDeviation.h"

namespace perilymph::cli {

/// Data of the haptic surface in the --json output.
struct HapticSurfaceNumbers {
  int triangles = 0;
  int visualTriangles = 0;
  anatomy::SurfaceDeviation surfaceDistance;
};

/// Writes a surface in W with a title; mirrored for a left ear.
Result<void> writeEar(anatomy::Surface surface, const std::string& what, const std::string& label,
                      anatomy::Side side, const std::string& file);

/// Writes the surface of --surface with --part.
Result<void> writePart(const anatomy::ScalaTympani& scala, const std::string& label,
                       anatomy::Side side, const AnatomyOptions& options);

/// Writes the surface of --haptic-surface.
Result<HapticSurfaceNumbers> writeHapticSurface(const anatomy::ScalaTympani& scala,
                                                const std::string& label, anatomy::Side side,
                                                const AnatomyOptions& options);

}  // namespace perilymph::cli
