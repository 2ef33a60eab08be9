// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the surface files with any bytes. The first byte selects the file format.

#include <cmath>

#include "InputFile.h"
#include "Seeds.h"
#include "perilymph/imaging/SurfaceReader.h"

namespace perilymph::fuzz {

namespace {

void checkSurface(const anatomy::Surface& surface)
{
  const int points = static_cast<int>(surface.points.size());
  promise(!surface.triangles.empty(), "a surface has triangles");
  for (const auto& triangle : surface.triangles)
    for (const int corner : triangle)
      promise(corner >= 0 && corner < points, "a triangle's corners exist");
}

}  // namespace

std::vector<Bytes> seeds() { return corpusOf("surface_file"); }

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile kinds[] = {fuzz::InputFile("a.stl"), fuzz::InputFile("a.ply"),
                                    fuzz::InputFile("a.vtp")};
  if (size == 0) return 0;
  // 'S', 'P' or 'V' in the stored corpus.
  fuzz::InputFile& file = kinds[data[0] == 'S' ? 0 : data[0] == 'P' ? 1 : data[0] % 3];
  const auto surface = imaging::readSurface(file.holding({data + 1, size - 1}));
  if (surface)
    fuzz::checkSurface(*surface);
  else
    fuzz::promise(!surface.error().message.empty(), "a refusal has a sentence");
  return 0;
}
