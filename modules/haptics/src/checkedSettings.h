// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Allowed ranges of the engine's settings.

#include <memory>

#include "perilymph/haptics/InsertionEngine.h"

namespace perilymph::haptics {

/// Maximum force scale: raises 1 mN to the friction of a consumer device.
inline constexpr double maxForceScale = 100.0;

/// Returns the model. @throws std::invalid_argument with a message for null.
std::shared_ptr<const mechanics::InsertionModel> checkedModel(
    std::shared_ptr<const mechanics::InsertionModel> model);

/// Returns the settings. @throws std::invalid_argument with a message for one out of range.
EngineSettings checkedSettings(const EngineSettings& settings);

}  // namespace perilymph::haptics
