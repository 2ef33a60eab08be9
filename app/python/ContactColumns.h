// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Positions of electrode contacts as NumPy columns.

#include <vector>

#include "PythonErrors.h"
#include "perilymph/analysis/ContactPositions.h"

namespace perilymph::python {

/// Columns of the contacts from the tip; NaN for those that are not inserted, except their depth.
py::dict contactColumns(const std::vector<analysis::ContactPosition>& contacts);

}  // namespace perilymph::python
