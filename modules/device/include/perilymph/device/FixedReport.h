#pragma once

// A report that is always the same.

#include <cstdint>
#include <vector>

#include "perilymph/device/ReportDescriptor.h"

namespace perilymph::device {

/// A report to be sent as it is.
struct FixedReport {
  ReportKind kind = ReportKind::output;  ///< Output or feature.
  std::vector<std::uint8_t> bytes;       ///< The report's number first, 0 if it has none.
};

}  // namespace perilymph::device
