// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The flags of a measurement.

#include <optional>
#include <vector>

#include "LumenProfile.h"
#include "ModiolarSections.h"
#include "RoundWindow.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::ct {

/// What is known beside the measures.
struct FlagEvidence {
  const CtVolume& volume;
  const MeasureRequest& request;
  const SectionCheck& sections;
  const LumenFindings& lumen;
  const RoundWindow& window;
  bool isLandmarkContradicted;
};

/// The flags that measures deserve, in the order of `Flag`.
std::vector<Flag> raisedFlags(const CochleaMeasures& measures, const FlagEvidence& evidence);

}  // namespace perilymph::ct
