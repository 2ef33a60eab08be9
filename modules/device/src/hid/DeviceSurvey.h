// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A survey with given profiles.

#include <vector>

#include "codec/DeviceProfile.h"
#include "perilymph/device/DeviceRegistry.h"

namespace perilymph::device {

DeviceSurvey surveyDevices(const ProfileCatalog& catalog, const SystemRoots& roots);

}  // namespace perilymph::device
