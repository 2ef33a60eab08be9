#pragma once

// Lines and glowing bands that face the viewer, with edges that fade out: smooth on a CPU that
// draws without multisampling.

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

/// How a line fades across: over one pixel at its rim, or all the way from its middle.
enum class LineEdge { firm, glow };

/// Polylines as strips of triangles in the plane of the picture. Clear, add lines, then build for
/// the view; again whenever lines or view change.
class SoftLines {
public:
  SoftLines();

  void clear();
  /// Begins a line; points follow.
  void begin(LineEdge edge);
  void add(const LinePoint& point) { points_.push_back(point); }
  /// Writes the strips. `toward_mm` lifts them toward the viewer, over what they belong to.
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
