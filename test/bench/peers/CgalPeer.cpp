// SPDX-License-Identifier: BSD-3-Clause

// CGAL's AABB tree: the closest point, in double precision, with an unlimited search.

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

#include "Peer.h"

namespace {

using namespace perilymph;

class CgalPeer {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

public:
  explicit CgalPeer(const anatomy::Surface& wall_mm)
  {
    const auto corner = [&wall_mm](int index) {
      const auto& point = wall_mm.points[static_cast<std::size_t>(index)];
      return Kernel::Point_3(point[0], point[1], point[2]);
    };
    for (const auto& each : wall_mm.triangles)
      triangles_.emplace_back(corner(each[0]), corner(each[1]), corner(each[2]));
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
    tree_.accelerate_distance_queries();
  }

  double distance(const Eigen::Vector3d& center_mm)
  {
    const Kernel::Point_3 center(center_mm.x(), center_mm.y(), center_mm.z());
    return std::sqrt(tree_.squared_distance(center));
  }

private:
  Triangles triangles_;
  Tree tree_;
};

BENCHMARK(bench::nearestWallBy<CgalPeer>)->Name("lumen/cgal")->Apply(bench::sizes);

}  // namespace
