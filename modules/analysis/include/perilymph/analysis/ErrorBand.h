// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Uncertainty of a patient's cochlear measures due to errors of the CT measurements.

#include <functional>
#include <vector>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// Assumed error of one length measured in CT, a standard deviation: about a voxel of a cone-beam scan. Ours;
/// confidence low.
inline constexpr Length measuringError = millimeters(0.1);

/// Errors of A, B and H of a patient: those that the measurement states, else the assumed one.
anatomy::BasalTurnErrors errorsOf(const anatomy::Patient& patient, Length assumed = measuringError);

/// Half width of the 95 % interval of each measure, in the measure's own unit. Each given length is changed
/// by its error (errorsOf()), and the model is built and measured again; errors add as squares, with the
/// correlations r that the measurement states and the error f of the measure's formula:
///
///     d_i = m(x + e_i) - m(x),   band(m) = 1.96 sqrt(sum over i, j of r_ij d_i d_j + f^2)
///
/// It covers the errors of the given lengths and the choice of a formula, not the error of the model. Empty for an anatomy
/// without patient measures. Takes as long as building two or three anatomies.
///
/// @param error      Error of lengths whose measurement states none.
/// @param measures   Measures of the built cochlea, from `measuring`.
/// @param measuring  Measures what a cochlea was built to: measure(), or fewer or other measures.
Result<std::vector<double>> errorBands(
    const anatomy::Cochlea& cochlea, const std::vector<Measure>& measures,
    Length error = measuringError,
    const std::function<std::vector<Measure>(const anatomy::ScalaTympani&,
                                             const anatomy::Cochlea&)>& measuring = measure);

}  // namespace perilymph::analysis
