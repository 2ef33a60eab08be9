// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Frames of a scene in which little moves while its camera rests.

#include <vtkNew.h>
#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <unordered_map>
#include <unordered_set>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkOpaquePass;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkTranslucentPass;

namespace perilymph::visualization {

/// Draws the solid and translucent parts of a scene. While the camera rests, the parts that rest are drawn once
/// into a picture that is kept; each later frame restores it and draws anew only the tiles in which a part
/// moves or a point of a resting part has another color.
///
/// In those tiles every part is drawn, in the scene's order, so that a frame equals, bit by bit, one that is
/// drawn as a whole, also where translucent parts lie before and behind a moving one. The other tiles are
/// closed by their depth, which is the nearest: nothing passes the depth test there.
///
/// The picture is drawn again after a change of the camera, the viewport, the background, and of the points,
/// triangles, texture, property, visibility or clipping of any resting part. Lights are constant. In stereo and
/// with multisampling nothing is kept.
class RestingPicture : public vtkRenderPass {
public:
  static RestingPicture* New();
  vtkTypeMacro(RestingPicture, vtkRenderPass)

      /// A part that moves in most frames, such as the array; all others rest.
      void addMoving(vtkActor& actor)
  {
    moving_.insert(&actor);
  }
  /// False: each frame is drawn as a whole.
  void setKept(bool isKept) { mayKeep_ = isKept; }
  /// Fraction of the viewport that the last frame drew anew; 1 for a frame that was drawn as a whole.
  double drawnFraction() const { return drawnFraction_; }

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  RestingPicture();
  ~RestingPicture() override;

private:
  /// All that the picture depends on.
  struct Look {
    std::array<double, 32> camera{};  ///< Matrices of view and projection, by rows.
    std::array<int, 4> viewport{};    ///< Left, bottom, width, height [px].
    std::array<double, 4> background{};
    std::vector<std::pair<vtkActor*, vtkMTimeType>> parts;  ///< In drawing order.

    friend bool operator==(const Look&, const Look&) = default;
  };
  /// Rectangle of tiles, both ends included.
  struct TileRange {
    int left = 0, bottom = 0, right = -1, top = -1;
  };
  /// The triangles of a resting mesh, and those of them that are drawn in a frame.
  struct Patch;

  static bool canKeep(const vtkRenderState& state);
  Look lookOf(const vtkRenderState& state) const;
  void draw(vtkRenderer& renderer, std::vector<vtkProp*> props);
  void keep(const vtkRenderState& state, vtkOpenGLRenderWindow& window);
  void copyPicture(vtkOpenGLRenderWindow& window, bool isRestored);
  void planPatch(vtkActor& actor);
  void markMoving(vtkActor& actor);
  void markRecolored(vtkActor& actor);
  void mark(const TileRange& range);
  void markAll();
  bool isMarked(const TileRange& range) const;
  void openMarkedTiles(vtkRenderer& renderer, vtkOpenGLRenderWindow& window);
  vtkProp* patched(vtkProp* prop);
  /// Calls use(range) with the tiles that each triangle of an actor's mesh may touch.
  template <class Use>
  void forTilesOf(vtkActor& actor, Use use);

  bool mayKeep_ = true;
  bool isKept_ = false;
  double drawnFraction_ = 1.0;
  std::unordered_set<vtkActor*> moving_;
  Look look_;
  int columns_ = 0, rows_ = 0;
  std::vector<unsigned char> tiles_;  ///< 1: drawn anew in this frame; by rows from the lower left.
  std::vector<std::array<float, 2>> places_px_;  ///< Memory of forTilesOf().
  std::unordered_map<vtkMapper*, Patch> patches_;
  vtkNew<vtkOpaquePass> opaque_;
  vtkNew<vtkTranslucentPass> translucent_;
  vtkSmartPointer<vtkOpenGLFramebufferObject> picture_;
};

}  // namespace perilymph::visualization
