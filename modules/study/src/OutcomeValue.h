// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "perilymph/study/StudyReport.h"

namespace perilymph::study {

/// An insertion's value of a quantity, in the unit of its title.
double valueOf(const StudyResult& result, Outcome outcome);

}  // namespace perilymph::study
