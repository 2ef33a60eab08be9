#pragma once

// Triangles whose corners move but whose order stays: written in place, drawn by one actor.

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <array>
#include <vector>

#include "Palette.h"

class vtkActor;
class vtkCellArray;
class vtkFloatArray;
class vtkOpenGLPolyDataMapper;
class vtkPoints;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace perilymph::visualization {

/// Three corners by their numbers, counterclockwise seen from outside.
using Triangle = std::array<int, 3>;

/// A triangle mesh of points with normals and, if asked for, a color each.
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

  /// Tells VTK that points and normals, or colors, were written.
  void pointsChanged();
  void colorsChanged();

  void paint(const Rgba& color);  ///< The uniform color.
  vtkActor& actor() { return *actor_; }
  /// A second actor of the same triangles, for a look of its own.
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
