// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Renders a picture of an insertion into a file, without a window.

#include <filesystem>
#include <memory>
#include <optional>

#include "perilymph/foundation/Result.h"
#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::visualization {

/// Content, view and file of a picture.
struct PictureRequest {
  // Shared, because models share ownership of their anatomy.
  std::shared_ptr<const anatomy::ScalaTympani> scala;
  std::optional<electrode::ArrayDesign> array;
  anatomy::Side side = anatomy::Side::right;
  const haptics::Snapshot* now = nullptr;  ///< The array; if null, only the scala is drawn.
  CameraPreset view = CameraPreset::surgeon;
  int width = 1280;            ///< Pixels, 64 to 8192.
  int height = 960;            ///< Pixels, 64 to 8192.
  std::filesystem::path file;  ///< Ends in .png.
  SceneStyle style;
};

/// Renders a picture into its file, atomically. Without a display it starts a private X server
/// (Xvfb) for the duration of the call; an error if that is not installed.
Result<void> renderPicture(const PictureRequest& request);

/// Whether pictures can be rendered: a display responds and supports OpenGL 3.2.
Result<void> canRender();

}  // namespace perilymph::visualization
