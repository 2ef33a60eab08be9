// SPDX-License-Identifier: BSD-3-Clause

// FCL's distance between a sphere and a mesh in a bounding-volume tree, in double precision. It
// gives no distance for overlapping shapes, so the sphere has a radius of 1 nm, which is added.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/distance.h>

#include <vector>

#include "Peer.h"

namespace {

using namespace perilymph;

constexpr double radius_mm = 1e-6;

class FclPeer {
public:
  explicit FclPeer(const anatomy::Surface& wall_mm) : sphere_(radius_mm)
  {
    std::vector<fcl::Vector3d> points;
    for (const auto& each : wall_mm.points) points.emplace_back(each[0], each[1], each[2]);
    std::vector<fcl::Triangle> triangles;
    const auto name = [](int index) { return static_cast<std::size_t>(index); };
    for (const auto& each : wall_mm.triangles)
      triangles.emplace_back(name(each[0]), name(each[1]), name(each[2]));
    wall_.beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
    wall_.addSubModel(points, triangles);
    wall_.endModel();
  }

  double distance(const Eigen::Vector3d& center_mm)
  {
    fcl::Transform3d place = fcl::Transform3d::Identity();
    place.translation() = center_mm;
    fcl::DistanceResultd result(1e3 * bench::reach);
    fcl::distance(&sphere_, place, &wall_, fcl::Transform3d::Identity(), fcl::DistanceRequestd(),
                  result);
    return result.o1 == nullptr ? -1.0 : result.min_distance + radius_mm;
  }

private:
  fcl::Sphered sphere_;
  fcl::BVHModel<fcl::OBBRSSd> wall_;
};

BENCHMARK(bench::nearestWallBy<FclPeer>)->Name("lumen/fcl")->Apply(bench::sizes);

}  // namespace
