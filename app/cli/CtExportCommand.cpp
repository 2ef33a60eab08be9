// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"
#include "Terminal.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/VolumeWriter.h"
#endif

namespace perilymph::cli {

#if PERILYMPH_HAS_TOOLKIT

Result<void> ctExport(const CtExportOptions& options)
{
  const auto loaded = imaging::readCt(options.path, options.series);
  if (!loaded) return loaded.error();
  if (const auto done = imaging::writeVolume(loaded->volume, options.out); !done)
    return done.error();
  const auto& size = loaded->volume.size();
  print(
      "{} x {} x {} voxels written without patient data; what they show of a face is not removed\n",
      size[0], size[1], size[2]);
  if (const std::size_t count = loaded->volume.unmeasuredCount(); count > 0)
    print("{} voxels that were not measured are written as air ({} HU)\n", count,
          ct::asAir(ct::unmeasured));
  for (const std::string& warning : loaded->series.warnings) print("{}\n", warning);
  return {};
}

#else

Result<void> ctExport(const CtExportOptions&)
{
  return Error{"This build has no VTK, so it cannot read a CT; use a build of the preset release."};
}

#endif

}  // namespace perilymph::cli
