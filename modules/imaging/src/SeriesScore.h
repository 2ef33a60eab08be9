// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which series of an examination is the one of the temporal bone.

#include <string>

#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {

/// True for reconstruction kernels that are made for bone, by their makers' names.
bool isBoneKernel(const std::string& kernel);

/// How well a series suits the measurement of a cochlea, 0 to 100: 60 for fine voxels, 20 for a
/// bone kernel, 15 for an extent of 25 mm or more, 5 for original images. 0 with an obstacle.
double scoreOf(const CtSeries& series, bool isDerived);

/// Sentences about voxels and extent that affect a measurement.
void addSizeWarnings(CtSeries& series);

}  // namespace perilymph::imaging
