// SPDX-License-Identifier: BSD-3-Clause

// The measurement, stage by stage.

#include <algorithm>
#include <utility>

#include "LumenWall.h"
#include "Padding.h"
#include "Refusal.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Units.h"
#include "pipeline/Pipeline.h"

namespace perilymph::ct {
namespace {

constexpr double maxVoxel_mm = 1.0;
constexpr double hFirst_deg = 20.0;  // below this angle the vestibule opens into the lumen

Eigen::Vector3d sliceNormal(const CtVolume& volume)
{
  // The slice normal is the axis with the largest spacing; for equal spacings the third.
  const Eigen::Vector3d spacing = volume.spacing_mm();
  Eigen::Index axis = 2;
  for (Eigen::Index i = 0; i < 3; ++i)
    if (spacing[i] > 1.05 * spacing[axis]) axis = i;
  return volume.lpsFromIndex().block<3, 1>(0, axis).normalized();
}

}  // namespace

Eigen::Vector2d Pipeline::blurGuess(const CtVolume& volume)
{
  const Eigen::Vector3d spacing = volume.spacing_mm();
  return {std::max(0.15, 0.6 * spacing.minCoeff()), std::max(0.17, 0.5 * spacing.maxCoeff())};
}

Pipeline::Pipeline(const CtVolume& volume, const MeasureRequest& request, const MeanLumen& mean)
    : volume_(volume),
      request_(request),
      family_(mean),
      points_(meanTemplate(family_)),
      fit_(family_, sliceNormal(volume), blurGuess(volume)),
      axis_W_(clinicalAxis_W(
          wallOf(ShapedLumen(family_, LumenShape::priorMean()), degrees(hFirst_deg).si())))
{
}

Result<CochleaMeasures> Pipeline::run()
{
  auto chosen = choose(std::nullopt);
  if (!chosen) return chosen.error();
  if (!request_.click_P && request_.starts.empty()) considerOther(*chosen);
  auto free = refined(std::move(chosen->best));
  if (!free) return free.error();
  const FitResult best = request_.marks.isEmpty() ? *std::move(free) : corrected(*std::move(free));
  if (isStopped()) return canceled();
  if (const auto done = checkMisfit(volume_, best); !done) return done.error();
  if (const auto done = checkClimb(volume_, family_, best); !done) return done.error();
  return measured(best, chosen->mirrored);
}

Result<CochleaMeasures> measureCochlea(const CtVolume& volume, const MeasureRequest& request)
{
  const double coarsest = volume.spacing_mm().maxCoeff();
  if (!(coarsest <= maxVoxel_mm))
    return Error{
        "A voxel is %1 mm long; at most 1.0 mm is allowed, and 0.6 mm or less is advised. Take a "
        "series with thinner slices.",
        std::to_string(coarsest).substr(0, 4)};
  const auto mean = MeanLumen::make();
  if (!mean) return mean.error();
  const auto marked = withPaddingMarked(volume, request.click_P);
  return Pipeline(marked ? *marked : volume, request, *mean).run();
}

}  // namespace perilymph::ct
