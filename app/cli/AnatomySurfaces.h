#pragma once

// The shapes that `anatomy` writes.

#include <string>

#include "Commands.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/SurfaceDeviation.h"

namespace perilymph::cli {

/// What --json says of the haptic surface.
struct HapticSurfaceNumbers {
  int triangles = 0;
  int visualTriangles = 0;
  anatomy::SurfaceDeviation surfaceDistance;
};

/// Writes a surface in W with a title; a left ear as the mirror image of the right one inside.
Result<Done> writeEar(anatomy::Surface surface, const std::string& what, const std::string& label,
                      anatomy::Side side, const std::string& file);

/// Writes what --surface with --part asks for.
Result<Done> writePart(const anatomy::ScalaTympani& scala, const std::string& label,
                       anatomy::Side side, const AnatomyOptions& options);

/// Writes what --haptic-surface asks for.
Result<HapticSurfaceNumbers> writeHapticSurface(const anatomy::ScalaTympani& scala,
                                                const std::string& label, anatomy::Side side,
                                                const AnatomyOptions& options);

}  // namespace perilymph::cli
