// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ReferenceCurve.h"

#include "perilymph/analysis/Reference.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::charts {

Result<ReferenceCurve> loadReference(const std::filesystem::path& file)
{
  const auto reference = analysis::loadReference(file);
  if (!reference) return reference.error();
  if (reference->points.empty())
    return Error{"%1 has no [[point]]; a curve needs at least one.", file};
  ReferenceCurve curve;
  curve.label = reference->label;
  curve.source = reference->source;
  for (const analysis::PrintedForce& point : reference->points)
    curve.points.push_back({inMillimeters(meters(point.travel)),
                            inMillinewtons(newtons(point.mean)),
                            inMillinewtons(newtons(point.standardDeviation))});
  return curve;
}

Result<ReferenceCurve> publishedExperiment()
{
  return loadReference(resource("resources/reference/todd-naghdy-experiment.toml"));
}

}  // namespace perilymph::charts
