#pragma once

// The ranges an engine can run in.

#include "perilymph/haptics/InsertionEngine.h"

namespace perilymph::haptics {

/// Greatest magnification of the force shown: lifts 1 mN to the friction of a consumer device.
inline constexpr double maxForceScale = 100.0;

/// Gives the settings back. @throws std::invalid_argument with a sentence for one out of range.
EngineSettings checkedSettings(const EngineSettings& settings);

}  // namespace perilymph::haptics
