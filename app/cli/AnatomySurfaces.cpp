// SPDX-License-Identifier: BSD-3-Clause
#include "AnatomySurfaces.h"

#include "perilymph/anatomy/ScalaVestibuli.h"
#include "perilymph/anatomy/Surface.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/imaging/DecimatedSurface.h"
#endif

namespace perilymph::cli {

namespace {

// Sufficient for display: the wall's triangles are about 0.1 mm long.
constexpr int wallTriangles = 20'000;
constexpr int membraneTriangles = 4'000;

anatomy::Surface partOf(const anatomy::ScalaTympani& scala, const std::string& part)
{
  if (part == "membrane") return anatomy::membraneSurface(scala, membraneTriangles);
  if (part == "vestibuli") return anatomy::vestibuliSurface(scala, wallTriangles);
  return anatomy::wallSurface(scala, wallTriangles);
}

}  // namespace

Result<void> writeEar(anatomy::Surface surface, const std::string& what, const std::string& label,
                      anatomy::Side side, const std::string& file)
{
  const bool isLeft = side == anatomy::Side::left;
  if (isLeft) {
    for (auto& point : surface.points) point[1] = -point[1];
    for (auto& corners : surface.triangles) std::swap(corners[1], corners[2]);
  }
  const std::string title = "Perilymph, " + what + " of " + label + (isLeft ? ", left" : ", right");
  return anatomy::writeSurface(surface, title, file);
}

Result<void> writePart(const anatomy::ScalaTympani& scala, const std::string& label,
                       anatomy::Side side, const AnatomyOptions& options)
{
  return writeEar(partOf(scala, options.part), options.part, label, side, options.surface);
}

#if PERILYMPH_HAS_TOOLKIT
Result<HapticSurfaceNumbers> writeHapticSurface(const anatomy::ScalaTympani& scala,
                                                const std::string& label, anatomy::Side side,
                                                const AnatomyOptions& options)
{
  const auto haptic = imaging::hapticSurface(scala, wallTriangles);
  if (!haptic) return haptic.error();
  if (const auto done =
          writeEar(haptic->surface, "haptic surface", label, side, options.hapticSurface);
      !done)
    return done.error();
  return HapticSurfaceNumbers{static_cast<int>(haptic->surface.triangles.size()),
                              haptic->visualTriangles, haptic->surfaceDistance};
}
#else
Result<HapticSurfaceNumbers> writeHapticSurface(const anatomy::ScalaTympani&, const std::string&,
                                                anatomy::Side, const AnatomyOptions&)
{
  return Error{
      "This build has no VTK, so it cannot make a haptic surface; use --surface, or a build of the "
      "preset release."};
}
#endif

}  // namespace perilymph::cli
