#pragma once

// The picture in the middle of the window: the array in the cochlea, as the surgeon sees it.

#include <memory>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/visualization/Quality.h"
#include "perilymph/visualization/SceneStyle.h"

class vtkRenderer;
class vtkRenderWindow;

namespace perilymph::visualization {

/// What of the scene can be switched off.
enum class Part { wallForce, contactArrows, membrane, styletAndTweezers, scala };

/// Where to look from.
enum class CameraPreset {
  surgeon,     ///< Along the modiolus, apex toward the viewer, the opening at the left.
  microscope,  ///< Down the opening along the approach, close.
  overview,    ///< From above and aside, all of scala and array.
  followTip,   ///< As the surgeon, close, and the tip stays in the middle.
  section      ///< Across the basal turn: the lumen from its side.
};

/// How the two eyes get their pictures.
enum class Stereo {
  off,
  anaglyph,     ///< Red for the left eye, cyan for the right one.
  sideBySide,   ///< Left and right half, each half as wide.
  interlaced,   ///< Line by line.
  quadBuffered  ///< Two buffers of the display; only where its window has them.
};

/// Angle between the eyes: 24 mm between the beams of an operating microscope at its working
/// distance of 250 mm.
inline constexpr double eyeAngle_deg = 5.5;

/// The scala tympani, the array in it and the forces between them. Millimeters inside VTK; a left
/// ear is mirrored here, y to -y.
///
/// The projection is parallel, so that the scale bar holds everywhere in the picture.
class InsertionScene {
public:
  InsertionScene(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array,
                 anatomy::Side side, Quality quality = Quality::software,
                 const SceneStyle& style = {});
  ~InsertionScene();
  InsertionScene(const InsertionScene&) = delete;
  InsertionScene& operator=(const InsertionScene&) = delete;

  /// Adds the renderer to a window and turns the window's multisampling off.
  void attachTo(vtkRenderWindow& window);
  vtkRenderer& renderer();

  /// Moves the array with all that belongs to it, and colors the wall; pipelines and arrays are
  /// kept. A snapshot with fewer than 2 nodes, or with one that is not finite, hides the array.
  void show(const haptics::Snapshot& now);

  void setVisible(Part part, bool visible);
  bool isVisible(Part part) const;
  /// Depth by two eyes. The plane of the focus stays where it is in both pictures; what lies a
  /// height h toward the viewer is 2 h tan(eyeAngle_deg / 2) further left in the right eye's.
  void setStereo(Stereo stereo);
  Stereo stereo() const noexcept;
  /// Sizes of type and lines for a screen's pixel ratio; 1 by default.
  void setScale(double pixelRatio);
  /// Where the scale bars stand above the lower edge, at pixel ratio 1; 34 by default. A window
  /// that writes below them asks for more.
  void setScaleBarMargin(int pixels);

  /// Looks from a preset at once; forgets what was turned, moved and zoomed.
  void lookFrom(CameraPreset preset);
  /// Goes to a preset in 250 ms, while stepCamera() is called.
  void glideTo(CameraPreset preset);
  /// Looks from where another scene is looked at now.
  void lookAs(const InsertionScene& other);
  /// One frame of the glide and of following the tip. @return Whether the camera is still moving.
  bool stepCamera(double seconds);
  CameraPreset preset() const noexcept;

  /// Magnification of a surgical microscope, 4 to 32: at 10 the picture is 17 mm high.
  void setMagnification(double times);
  double magnification() const noexcept;
  /// Turns the model under the camera; the camera's look stays with the preset.
  void rotateModel(double azimuth_deg, double elevation_deg, double roll_deg);
  /// Moves the model in the plane of the picture.
  void moveModel(double right_mm, double up_mm);
  /// Above 1 comes closer.
  void zoom(double factor);

  /// Length of the scale bar in the last picture drawn: 1, 2 or 5 times a power of ten.
  double scaleBarLength_mm() const;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::visualization
