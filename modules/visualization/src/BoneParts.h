// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Visual model of the bone of a CT: its surface, cut open by a plane, and the CT on the cut.

#include <vtkNew.h>

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "Mesh.h"
#include "PictureSpace.h"
#include "perilymph/visualization/BoneLayer.h"

class vtkImageData;
class vtkPlane;
class vtkPolyData;
class vtkRenderer;
class vtkTexture;

namespace perilymph::visualization {

/// The bone's surface at two resolutions. Lit at its vertices once per view, which is faster on a CPU
/// than at every pixel; what lies deeper behind the cut is darker.
class BoneParts {
public:
  /// @param picture  From the model's frame [m] to picture space [mm]; may mirror.
  BoneParts(std::shared_ptr<const BoneModel> bone, const Eigen::Affine3d& picture,
            const SceneColors& palette);
  ~BoneParts();

  void addTo(vtkRenderer& renderer);
  void removeFrom(vtkRenderer& renderer);
  void setVisible(bool isVisible);
  bool isVisible() const { return isVisible_; }
  /// Shows the coarse surface while something moves.
  void setMoving(bool isMoving);
  bool isMoving() const { return isMoving_; }

  const BoneModel& model() const { return *bone_; }
  /// No cut if empty.
  void setCut(const std::optional<CutPlane>& cut);
  const std::optional<CutPlane>& cut() const { return cut_; }
  void lookFrom(const ViewFrame& view);
  /// Triangles of the surface that is shown.
  std::size_t triangles() const { return shown().triangles; }

private:
  struct Level {
    std::vector<Eigen::Vector3d> places, normals;  ///< Picture space [mm].
    std::size_t triangles = 0;
    Mesh mesh{Mesh::Coloring::perPoint};
    bool isLit = false;
  };
  void plan(Level& level, const anatomy::Surface& surface);
  void light(Level& level);
  void paintFace();
  void showParts();
  const Level& shown() const { return isMoving_ ? coarse_ : fine_; }
  Level& shown() { return isMoving_ ? coarse_ : fine_; }

  std::shared_ptr<const BoneModel> bone_;
  Eigen::Affine3d picture_;
  const SceneColors& palette_;
  Level fine_, coarse_;
  bool isVisible_ = true, isMoving_ = false;
  std::optional<CutPlane> cut_;
  ViewFrame view_;
  int facePixels_ = 0;  ///< Edge of the painted cut.
  vtkNew<vtkPlane> plane_;
  vtkNew<vtkPolyData> face_;
  vtkNew<vtkImageData> picturePixels_;
  vtkNew<vtkTexture> texture_;
  vtkNew<vtkActor> faceActor_;
};

}  // namespace perilymph::visualization
