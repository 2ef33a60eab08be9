// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a surgeon finds the way by: round window, axis of the basal turn, line of approach.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "PictureSpace.h"
#include "SoftLines.h"
#include "perilymph/visualization/BoneLayer.h"

class vtkRenderer;

namespace perilymph::visualization {

/// Where a point of picture space is in a renderer's picture [px], from the upper left corner.
Eigen::Vector2d placeIn(vtkRenderer& renderer, const Eigen::Vector3d& point);

/// Places in picture space [mm].
struct LandmarkPlaces {
  std::optional<Eigen::Vector3d> roundWindow;
  std::optional<std::array<Eigen::Vector3d, 2>> axis;      ///< From the base to beyond the apex.
  std::optional<std::array<Eigen::Vector3d, 2>> approach;  ///< From outside into the opening.
  std::vector<Eigen::Vector3d> contacts;                   ///< Number 1 at the tip.
  std::vector<std::pair<std::string, Eigen::Vector3d>> others;  ///< By name.
  std::vector<MarkedCourse> courses;
};

/// Lines on top of everything else: in a parallel projection they are moved toward the viewer.
class LandmarkParts {
public:
  explicit LandmarkParts(const SceneColors& palette);

  void addTo(vtkRenderer& renderer);
  void setVisible(bool isVisible);
  bool isVisible() const { return isVisible_; }
  void place(LandmarkPlaces places) { places_ = std::move(places); }
  const LandmarkPlaces& places() const { return places_; }
  void lookFrom(const ViewFrame& view);

  /// Where the places are in the last picture; none while hidden.
  std::vector<SceneAnchor> anchorsIn(vtkRenderer& renderer) const;

private:
  const SceneColors& palette_;
  LandmarkPlaces places_;
  bool isVisible_ = true;
  SoftLines lines_;
};

}  // namespace perilymph::visualization
