// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Fingerprints of a model, which a replay compares with those of its recording.

#include <cstdint>

#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::mechanics {

/// Fingerprint of all data that the model was built from and that affects results: without names,
/// notes and sources.
std::uint64_t fingerprintOf(const InsertionModel& model);

/// The fingerprint in the first recordings of format 2: without the lumen's tables, the electrode
/// contacts and other data. Its definition must not change.
std::uint64_t formerFingerprintOf(const InsertionModel& model);

}  // namespace perilymph::mechanics
