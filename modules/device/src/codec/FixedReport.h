// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A constant report.

#include <cstdint>
#include <vector>

#include "codec/ReportDescriptor.h"

namespace perilymph::device {

/// A report to be sent unchanged.
struct FixedReport {
  ReportKind kind = ReportKind::output;  ///< Output or feature.
  std::vector<std::uint8_t> bytes;       ///< Report number first, 0 if unnumbered.
};

}  // namespace perilymph::device
