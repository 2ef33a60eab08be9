#pragma once

// What the operation view calls where it is looked from, and how for two eyes.

#include <QString>

#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::gui {

QString nameOf(visualization::CameraPreset preset);
QString nameOf(visualization::Stereo stereo);

}  // namespace perilymph::gui
