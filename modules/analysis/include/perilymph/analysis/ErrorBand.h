#pragma once

// How far the measures of a patient's cochlea may be off because the numbers from CT were.

#include <vector>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// The error of one length measured in CT that bands are given for: about a voxel of a cone-beam
/// scan. Ours; confidence low.
inline constexpr Length measuringError = millimeters(0.1);

/// For each measure its band, plus or minus, in the measure's own unit. Every number given is moved
/// by the error, the model built and measured again; independent errors add as squares:
///
///     band(m) = sqrt(sum over i of (m(x + e_i) - m(x))^2)
///
/// It holds the error of the numbers given and no other: not that of the model. Empty for an
/// anatomy that was built from no patient's numbers. Takes as long as building two or three
/// anatomies.
///
/// @param measures  Measures of the cochlea as built, from measure().
Result<std::vector<double>> errorBands(const anatomy::Cochlea& cochlea,
                                       const std::vector<Measure>& measures,
                                       Length error = measuringError);

}  // namespace perilymph::analysis
