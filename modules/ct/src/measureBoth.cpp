// SPDX-License-Identifier: BSD-3-Clause

// Both ears of a volume.

#include <cmath>
#include <string>
#include <utility>

#include "perilymph/ct/Measures.h"

namespace perilymph::ct {

Result<std::array<CochleaMeasures, 2>> measureBothCochleae(const CtVolume& volume,
                                                           const MeasureRequest& request)
{
  std::array<CochleaMeasures, 2> both;
  for (const std::size_t ear : {std::size_t{0}, std::size_t{1}}) {
    MeasureRequest one;
    one.side = ear == 0 ? anatomy::Side::right : anatomy::Side::left;
    one.stop = request.stop;
    if (request.onProgress)
      one.onProgress = [&request, ear](double fraction) {
        request.onProgress(0.5 * (static_cast<double>(ear) + fraction));
      };
    auto found = measureCochlea(volume, one);
    if (!found)
      return ear == 0 ? Error{"The right ear was not measured. %1", found.error().message}
                      : Error{"The left ear was not measured. %1", found.error().message};
    if (found->side != *one.side)
      return Error{
          "No %1 cochlea was found: the one found at x %2 mm (LPS) winds as in a %3 ear. Measure "
          "that ear alone, or take a series that shows both.",
          ear == 0 ? Sentence{"right"} : Sentence{"left"}, std::lround(found->center_P.x()),
          ear == 0 ? Sentence{"left"} : Sentence{"right"}};
    both[ear] = *std::move(found);
  }
  return both;
}

}  // namespace perilymph::ct
