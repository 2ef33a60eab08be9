// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The 3D view of the array in the cochlea.

#include <Eigen/Core>
#include <memory>
#include <span>

#include "perilymph/anatomy/Approach.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/visualization/BoneLayer.h"
#include "perilymph/visualization/Quality.h"
#include "perilymph/visualization/SceneStyle.h"

class vtkRenderer;
class vtkRenderWindow;

namespace perilymph::visualization {

/// Optional parts of the scene.
enum class Part {
  wallForce,
  contactArrows,
  membrane,
  styletAndTweezers,
  scala,
  landmarks  ///< Round window, axis, approach and, where it is known, the bone; hidden at first.
};

/// Camera presets.
enum class CameraPreset {
  surgeon,     ///< Along the modiolus, apex toward the viewer, the opening at the left.
  microscope,  ///< Along the approach into the opening, close.
  overview,    ///< Oblique from above, showing scala and array completely.
  followTip,   ///< As surgeon, close, with the tip centered.
  section      ///< Across the basal turn, showing the lumen from the side.
};

/// Stereo modes.
enum class Stereo {
  off,
  anaglyph,     ///< Red for the left eye, cyan for the right one.
  sideBySide,   ///< Left and right half, each with half the width.
  interlaced,   ///< Alternating lines.
  quadBuffered  ///< Two frame buffers; only if the window supports them.
};

/// The part of the picture that nothing covers, in fractions of its width and height from the lower left.
struct FreeArea {
  double left = 0.0, bottom = 0.0, right = 1.0, top = 1.0;

  friend bool operator==(const FreeArea&, const FreeArea&) = default;
};

/// Stereo angle: 24 mm between the light paths of an operating microscope at a working distance of
/// 250 mm.
inline constexpr double eyeAngle_deg = 5.5;

/// Round window, modiolar axis and line of approach of a scala [m, W].
SceneLandmarks landmarksOf(const anatomy::ScalaTympani& scala,
                           const anatomy::Approach& approach = {});

/// The scala tympani, the array in it and the forces between them. Millimeters inside VTK; a left
/// ear is mirrored here, y to -y.
///
/// The projection is parallel, so that the scale bar is valid everywhere in the picture.
class InsertionScene {
public:
  InsertionScene(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array,
                 anatomy::Side side, Quality quality = Quality::software,
                 const SceneStyle& style = {});
  ~InsertionScene();
  InsertionScene(const InsertionScene&) = delete;
  InsertionScene& operator=(const InsertionScene&) = delete;

  /// Adds the renderer to a window and disables the window's multisampling.
  void attachTo(vtkRenderWindow& window);
  vtkRenderer& renderer();

  /// Whether the picture of the parts that rest is kept while the camera rests, so that a frame draws
  /// only what moves; true by default. Frames are the same either way, bit by bit.
  void setRestingPartsKept(bool areKept);
  /// Fraction of the picture that the last frame drew anew; 1 for all of it.
  double drawnFraction() const;

  /// Updates the array and the colors of the wall; pipelines and meshes are reused. A snapshot with
  /// fewer than 2 nodes or with a non-finite one hides the array.
  void show(const haptics::Snapshot& now);
  /// Shows the array of another insertion into the same cochlea, translucent with a dashed outline;
  /// hidden without nodes.
  ///
  /// @param nodes_W  Base first, tip last [m].
  void showGhost(const electrode::ArrayDesign& array, std::span<const Eigen::Vector3d> nodes_W);

  void setVisible(Part part, bool visible);
  bool isVisible(Part part) const;
  /// Shows the line of approach in another direction than the axis of the opening.
  void setApproach(const anatomy::Approach& approach);
  /// Bone of the patient's CT in W, and the landmarks, which are those of the scala.
  BoneLayer& bone();
  /// Shows and hides the same parts as another scene.
  void showPartsOf(const InsertionScene& other);
  /// Sets the stereo mode. The focal plane has no disparity; a point at height h toward the viewer
  /// is 2 h tan(eyeAngle_deg / 2) further left for the right eye.
  void setStereo(Stereo stereo);
  Stereo stereo() const noexcept;
  /// Scales fonts and lines for a screen's pixel ratio; 1 by default.
  void setScale(double pixelRatio);
  /// Distance of the scale bars from the lower edge, at pixel ratio 1; 34 by default. Increase it
  /// for windows with text below them.
  void setScaleBarMargin(int pixels);

  /// From now on the presets that show the whole cochlea (surgeon, overview, section) frame it: they center
  /// it in the area and magnify it until it fills framedShare of its width or height, also when area or
  /// window change, until the user rotates, moves or zooms. Without an area they have a magnification of
  /// their own.
  void setFreeArea(const FreeArea& area);
  static constexpr double framedShare = 0.92;

  /// Switches to a preset at once; resets rotation, translation and zoom.
  void lookFrom(CameraPreset preset);
  /// Looks from the preset of another scene, framed as there, or with the magnification that its motion ends
  /// at.
  void keepViewOf(const InsertionScene& other);
  /// Moves to a preset within 250 ms, while stepCamera() is called.
  void glideTo(CameraPreset preset);
  /// Copies the current camera of another scene.
  void lookAs(const InsertionScene& other);
  /// One frame of camera motion. @return Whether the camera is still moving.
  bool stepCamera(double seconds);
  CameraPreset preset() const noexcept;

  /// Sets the magnification of a surgical microscope, 4 to 32: at 10 the picture is 17 mm high.
  void setMagnification(double times);
  double magnification() const noexcept;
  /// Rotates the model under the camera; the preset's orientation is kept.
  void rotateModel(double azimuth_deg, double elevation_deg, double roll_deg);
  /// Moves the model in the picture plane.
  void moveModel(double right_mm, double up_mm);
  /// Values above 1 zoom in.
  void zoom(double factor);

  /// Length of the scale bar in the last picture: 1, 2 or 5 times a power of ten.
  double scaleBarLength_mm() const;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::visualization
