#pragma once

// One picture of an insertion into a file, without a window.

#include <filesystem>
#include <memory>
#include <optional>

#include "perilymph/foundation/Result.h"
#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::visualization {

/// What to draw, from where, and into which file.
struct PictureRequest {
  // Shared, because models own their anatomy together with whoever draws it.
  std::shared_ptr<const anatomy::ScalaTympani> scala;
  std::optional<electrode::ArrayDesign> array;
  anatomy::Side side = anatomy::Side::right;
  const haptics::Snapshot* now =
      nullptr;  ///< Where the array is; without it only the scala is drawn.
  CameraPreset view = CameraPreset::surgeon;
  int width = 1280;            ///< Pixels, 64 to 8192.
  int height = 960;            ///< Pixels, 64 to 8192.
  std::filesystem::path file;  ///< Ends in .png.
  SceneStyle style;
};

/// Draws a picture into its file, which appears whole or not at all. Without a display it starts a
/// private X server (Xvfb) for the time of the call if that is installed, and says so if not.
Result<Done> renderPicture(const PictureRequest& request);

/// Whether pictures can be drawn here and now: a display that answers and offers OpenGL 3.2.
Result<Done> canRender();

}  // namespace perilymph::visualization
