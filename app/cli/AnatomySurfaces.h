#pragma once

// The shapes that `anatomy` writes.

#include <optional>

#include "Commands.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/SurfaceDeviation.h"

namespace perilymph::cli {

/// What --json says of the haptic surface.
struct HapticSurfaceNumbers {
  int triangles = 0;
  int visualTriangles = 0;
  anatomy::SurfaceDeviation deviation;
};

/// Writes what --surface with --part asks for; a left ear as the mirror image of the right one
/// inside.
Result<Done> writePart(const anatomy::ScalaTympani& scala, const std::string& label,
                       anatomy::Side side, const AnatomyOptions& options);

/// Writes what --haptic-surface asks for.
Result<HapticSurfaceNumbers> writeHapticSurface(const anatomy::ScalaTympani& scala,
                                                const std::string& label, anatomy::Side side,
                                                const AnatomyOptions& options);

}  // namespace perilymph::cli
