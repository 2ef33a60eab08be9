// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A triangle mesh with moving points and fixed topology, updated in place and drawn by one actor.

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <array>
#include <vector>

#include "SceneColors.h"

class vtkActor;
class vtkCellArray;
class vtkFloatArray;
class vtkOpenGLPolyDataMapper;
class vtkPoints;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace perilymph::visualization {

/// Indices of three corners, counterclockwise seen from outside.
using Triangle = std::array<int, 3>;

/// A triangle mesh of points with normals and optional vertex colors.
class Mesh {
public:
  enum class Coloring { uniform, perPoint };

  explicit Mesh(Coloring coloring);
  ~Mesh();
  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;

  /// Sets the number of points and the triangles between them.
  void shape(int points, const std::vector<Triangle>& triangles);
  /// Replaces the triangles alone.
  void connect(const std::vector<Triangle>& triangles);

  int points() const;
  Eigen::Map<Eigen::Vector3f> point(int index);
  Eigen::Map<Eigen::Vector3f> normal(int index);
  void setColor(int index, const Rgba& color);

  /// Marks points and normals, or colors, as modified.
  void pointsChanged();
  void colorsChanged();

  void paint(const Rgba& color);  ///< Sets a uniform color.
  vtkActor& actor() { return *actor_; }
  /// A second actor of the same triangles with its own properties.
  vtkSmartPointer<vtkActor> anotherActor() const;

private:
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkFloatArray> points_, normals_;
  vtkNew<vtkPoints> places_;  ///< Positions of points_.
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkCellArray> triangles_;
  vtkNew<vtkOpenGLPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace perilymph::visualization
