// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The bone around a cochlea in a scene, cut open, with what a surgeon finds the way by.

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/visualization/SceneStyle.h"

class vtkRenderer;

namespace perilymph::visualization {

struct ViewFrame;

/// A plane that removes the bone on one side of it, in the frame of a scene's model [m].
struct CutPlane {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d removed = Eigen::Vector3d::UnitZ();  ///< Unit, to the side without bone.
};

/// Bone of a CT in the frame of a scene: W [m] of an insertion, that of the points of a surface.
struct BoneModel {
  anatomy::Surface fine;    ///< Shown at rest; normals point out of the bone.
  anatomy::Surface coarse;  ///< Shown while the picture turns.
  /// The CT's intensity at a point [m]; empty outside of the volume.
  std::function<std::optional<double>(const Eigen::Vector3d& point)> intensity;
  double level = 0.0;     ///< From this intensity on it is bone.
  double contrast = 1.0;  ///< Intensity of dense bone above that of what lies beside it; positive.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< The ball that holds the bone [m].
  double radius = 0.0;                               ///< [m]
  CutPlane cut;                                      ///< Where it is cut at first.
};

/// The plane a length [m] further to the removed side, within the ball of a model.
CutPlane moved(const CutPlane& cut, double length, const BoneModel& bone);

/// A structure that a person marked along its course, in the frame of a scene's model [m].
struct MarkedCourse {
  std::string name;  ///< In the picture (UTF-8).
  std::vector<Eigen::Vector3d> points;
  /// From its nearest point to the line of approach.
  std::optional<std::array<Eigen::Vector3d, 2>> distance;
};

/// Places that a surgeon finds the way by, in the frame of a scene's model [m].
struct SceneLandmarks {
  std::optional<Eigen::Vector3d> roundWindow;
  std::optional<std::array<Eigen::Vector3d, 2>> axis;      ///< From the base to beyond the apex.
  std::optional<std::array<Eigen::Vector3d, 2>> approach;  ///< From outside into the opening.
  std::vector<Eigen::Vector3d> contacts;                   ///< Number 1 at the tip.
  /// Others, with their names in the picture (UTF-8).
  std::vector<std::pair<std::string, Eigen::Vector3d>> others;
  std::vector<MarkedCourse> courses;
};

/// A place of a scene that has a name in the picture.
struct SceneAnchor {
  enum class Kind { roundWindow, basalTurnAxis, approach, contact, other };
  Kind kind = Kind::roundWindow;
  int number = 0;                                   ///< The contact's, 1 at the tip.
  std::string name = {};                            ///< The name of another place.
  Eigen::Vector2d at_px = Eigen::Vector2d::Zero();  ///< From the upper left corner, device pixels.
};

/// Where a cut is held to be dragged.
struct CutHandle {
  Eigen::Vector2d at_px;  ///< From the upper left corner, device pixels.
  Eigen::Vector2d
      per_mm;  ///< Motion in the picture when the cut moves to the removed side [px/mm].
};

/// Where the line of approach is held to be turned about its inner end.
struct ApproachHandle {
  Eigen::Vector2d at_px;  ///< From the upper left corner, device pixels.
  double toViewer_mm;     ///< From the plane of the picture through the inner end.
};

/// Bone and landmarks of a scene, which owns it; hidden at first.
class BoneLayer {
public:
  /// @param picture  From the frame of the scene's model [m] to picture space [mm]; may mirror.
  BoneLayer(vtkRenderer& renderer, const Eigen::Affine3d& picture, const SceneStyle& style);
  ~BoneLayer();
  BoneLayer(const BoneLayer&) = delete;
  BoneLayer& operator=(const BoneLayer&) = delete;

  /// Shows bone, cut where its model says; none if null.
  void setBone(std::shared_ptr<const BoneModel> bone);
  /// The bone that is shown; null without one.
  const std::shared_ptr<const BoneModel>& bone() const;
  void setLandmarks(SceneLandmarks landmarks);
  void setVisible(bool isVisible);
  bool isVisible() const;
  /// Never shows the coarse surface, as on a graphics card.
  void keepFine();
  /// Shows the coarse surface while the picture turns or the cut moves.
  void setMoving(bool isMoving);
  bool isMoving() const;

  /// The cut; empty without bone.
  std::optional<CutPlane> cut() const;
  /// Moves the cut to the removed side [mm]; nothing without bone.
  void moveCut(double by_mm);
  /// Turns the cut to the viewer, through the center of the bone.
  void faceCut();

  /// Where the cut is held in the last picture; empty without bone or while hidden.
  std::optional<CutHandle> handle() const;
  /// Where the line of approach is held in the last picture: its outer end, or where it leaves the
  /// picture, with a margin [device pixels]. Empty without the line or while hidden.
  std::optional<ApproachHandle> approachHandle(double margin_px) const;
  /// Unit direction, in the frame of the scene's model, from the inner end of the line of approach to what
  /// lies at a place of the last picture, in front of the inner end by a distance. Empty without the line.
  std::optional<Eigen::Vector3d> approachTo(const Eigen::Vector2d& place_px,
                                            double toViewer_mm) const;
  /// Where the landmarks are in the last picture; none while hidden.
  std::vector<SceneAnchor> anchors() const;
  /// Triangles of the bone's surface that is shown.
  std::size_t triangles() const;

  /// Adds the lines, which are drawn over what was added before.
  void addLines();
  /// Prepares the next picture; called by the scene.
  void lookFrom(const ViewFrame& view);

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::visualization
