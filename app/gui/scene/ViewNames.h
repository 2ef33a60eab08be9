// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names of camera presets and stereo modes.

#include <QString>

#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::gui {

QString nameOf(visualization::CameraPreset preset);
QString nameOf(visualization::Stereo stereo);

}  // namespace perilymph::gui
