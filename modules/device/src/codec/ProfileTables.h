// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads the tables of a device profile that define positions in reports.

#include <string>
#include <vector>

#include "codec/DeviceProfile.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::device {

/// Exactly `count` integers within a range.
std::vector<std::int64_t> wholeNumbers(TomlReader& table, const char* key, double low, double high,
                                       std::size_t count);

/// Tables [input], [output], [calibration] and, for `encoders`, [linkage].
PlainLayout readPlainLayout(TomlReader& file, CodecKind kind, bool rendersForce);

/// Table [axes].
AxesLayout readAxesLayout(TomlReader& file, CodecKind kind);

/// Table [pid].
PidLayout readPidLayout(TomlReader& file, const AxesLayout& axes);

}  // namespace perilymph::device
