// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A surface with marked points as a 3D picture, for views without an insertion.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/visualization/BoneLayer.h"
#include "perilymph/visualization/SceneStyle.h"

class vtkRenderer;
class vtkRenderWindow;

namespace perilymph::visualization {

/// A translucent surface in the frame of its points, and the bone around it, seen in parallel
/// projection. Millimeters.
class SurfaceScene {
public:
  /// @param surface  Points in meters, triangles with outward normals; may be empty.
  explicit SurfaceScene(const anatomy::Surface& surface, const SceneStyle& style = {});
  ~SurfaceScene();
  SurfaceScene(const SurfaceScene&) = delete;
  SurfaceScene& operator=(const SurfaceScene&) = delete;

  /// Adds the renderer to a window.
  void attachTo(vtkRenderWindow& window);
  vtkRenderer& renderer();

  /// Shows points as small spheres [mm].
  void setPoints(const std::vector<Eigen::Vector3d>& points_mm);
  /// Shows a line of tubes, such as an array's center line; none if empty [mm].
  void setPath(const std::vector<Eigen::Vector3d>& points_mm, double radius_mm);

  /// Bone around the surface and landmarks, in meters; shown at first.
  BoneLayer& bone();
  /// Scales lines for a screen's pixel ratio; 1 by default.
  void setScale(double pixelRatio);

  /// Looks along a direction with another one downward in the picture, the whole surface in view;
  /// without one the whole bone.
  void lookAlong(const Eigen::Vector3d& away, const Eigen::Vector3d& down);
  /// Rotates the surface under the camera.
  void rotate(double azimuth_deg, double elevation_deg);
  /// Values above 1 zoom in.
  void zoom(double factor);

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::visualization
