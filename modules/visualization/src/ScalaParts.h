// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Visual model of the scala tympani: a shell of bone, its edges, and the basilar membrane.

#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "ContactField.h"
#include "Mesh.h"
#include "Silhouette.h"
#include "SoftLines.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/visualization/Quality.h"

class vtkRenderer;

namespace perilymph::visualization {

/// Wall, edges and membrane. The wall is drawn twice, far side first, which avoids sorting.
class ScalaParts {
public:
  ScalaParts(const anatomy::ScalaTympani& scala, const PictureSpace& space,
             const QualityTraits& traits, const SceneColors& palette);

  void addFarWall(vtkRenderer& renderer);
  void addMembrane(vtkRenderer& renderer);
  void addNearWall(vtkRenderer& renderer);

  /// Shows where the cochlear partition is torn.
  ///
  /// @param ranges  Angles from the round window at which each part begins and ends [rad].
  void tear(std::span<const std::array<double, 2>> ranges);
  /// Colors the wall by its force.
  void color(const ContactField& field);
  void lookFrom(const ViewFrame& view);
  void setVisible(bool wall, bool membrane);

  /// Corners of the wall's bounding box [mm].
  Eigen::Vector3d low() const { return low_; }
  Eigen::Vector3d high() const { return high_; }
  /// The points of the wall [mm].
  const std::vector<Eigen::Vector3d>& places() const { return places_; }

private:
  void plan(const anatomy::ScalaTympani& scala, const PictureSpace& space);
  void planMembrane(const anatomy::ScalaTympani& scala, const PictureSpace& space);
  void light(const ViewFrame& view);
  void paintTouched(int index);
  void sortIntoBins();
  long bin(int x, int y, int z) const;

  QualityTraits traits_;
  const SceneColors& palette_;
  Mesh wall_{Mesh::Coloring::perPoint};
  Mesh membrane_{Mesh::Coloring::uniform};
  Mesh torn_{Mesh::Coloring::uniform};         ///< Its torn parts; empty without one.
  std::vector<Triangle> membraneTriangles_;    ///< By pairs, one for each piece along the duct.
  double pieceAngle_ = 0.0;                    ///< Extent of a piece [rad].
  std::vector<std::array<double, 2>> ranges_;  ///< What is shown.
  vtkSmartPointer<vtkActor> nearWall_;
  SoftLines edges_, membraneEdges_;
  std::optional<Silhouette> silhouette_;
  std::vector<Polyline> silhouettes_, rims_, membraneRims_;
  ViewFrame litFrom_{.back = Eigen::Vector3d::Zero()};  ///< None yet.
  std::vector<Eigen::Vector3d> normals_;
  std::vector<Rgba> shell_;  ///< Color of each point without contact.
  Eigen::Vector3d low_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d high_ = Eigen::Vector3d::Zero();

  // For coloring: points of the wall in a grid with the bell's reach, and the points colored last.
  std::vector<Eigen::Vector3d> places_;
  std::unordered_map<long, std::vector<int>> bins_;
  std::vector<float> force_mN_mm_;
  std::vector<int> touched_;
};

}  // namespace perilymph::visualization
