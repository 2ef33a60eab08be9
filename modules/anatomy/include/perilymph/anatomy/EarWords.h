// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The ear in sentences; in files nameOf(Side) names it.

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::anatomy {

/// "left ear" or "right ear", for a sentence that is shown in any language.
Sentence earOf(Side side);

}  // namespace perilymph::anatomy
