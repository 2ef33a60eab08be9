// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lines and glowing bands that face the viewer, with fading edges: smooth on a CPU without
// multisampling.

#include <Eigen/Core>
#include <vector>

#include "Mesh.h"
#include "PictureSpace.h"

namespace perilymph::visualization {

/// One point of a line.
struct LinePoint {
  Eigen::Vector3d place;
  Rgba color;
  double halfWidth_mm;
};

/// Profile of a line: fading over one pixel at its edge, or from its center.
enum class LineEdge { firm, glow };

/// Polylines as triangle strips in the picture plane. Clear, add lines, then build for the view;
/// repeat when lines or view change.
class SoftLines {
public:
  SoftLines();

  void clear();
  /// Begins a line; its points follow.
  void begin(LineEdge edge);
  void add(const LinePoint& point) { points_.push_back(point); }
  /// Builds the strips, offset by `toward_mm` toward the viewer.
  void build(const ViewFrame& view, double toward_mm);

  vtkActor& actor() { return mesh_.actor(); }

private:
  struct Line {
    std::size_t first;
    LineEdge edge;
  };
  std::size_t lineEnd(std::size_t line) const;
  void connectStrips();

  std::vector<LinePoint> points_;
  std::vector<Line> lines_;
  std::vector<std::size_t> builtStarts_, starts_;
  std::vector<Triangle> triangles_;
  Mesh mesh_{Mesh::Coloring::perPoint};
};

}  // namespace perilymph::visualization
